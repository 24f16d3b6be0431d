<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name></name>
    <message>
        <source>{name} ends in &quot;{ending}&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end it in {endings}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are marks, but not both shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draw both shapes first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} vertices would be left, and a polygon has at least 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select all vertices to delete the whole shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the SVG declares entities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>save it as plain SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the SVG is damaged: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no outline on the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy a shape here, or a path in another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no blend without crossings was found: a shape is all but as narrow as rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>widen its narrowest parts, or add marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edge from vertex {i} at ({x:g}, {y:g}) is too short for new vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove that vertex or mark more correspondences nearby</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the marks are not pairs of vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give each mark as (vertex of the source, vertex of the target), counted from 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mark {number} names vertex {vertex} of the {name}, which has {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a vertex from 0 to {last}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marks {earlier} and {number} both name vertex {vertex} of the {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marks {first} {a} and {second} {b} come in one order round the source and in the other round the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove or move one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{where}: {what}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first} or {second}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} cannot be read: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give the path of a readable file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is no path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a folder that exists and may be written to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} cannot be written: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a folder, or a place where one may be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} cannot be made a folder: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} has the format &quot;{found}&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} does not name its format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a file of the format {names}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correct the file at this place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is damaged: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take an undamaged copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} has no pair &quot;{name}&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: pair &quot;{name}&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source (p)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target (q)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose one of {names}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} holds no pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a file with at least one pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} has two pairs &quot;{name}&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} has marks, but not both shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add the missing shape or remove the marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} shows the method &quot;{name}&quot;, which this program does not know</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open it with a newer starskel, or name one of {names}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} shows the method &quot;{name}&quot; twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name it once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is a project of version {version}; this program knows versions up to {newest}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open it with a newer starskel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is a project of version {version}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>versions count from 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points are not numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give rows of x and y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a polygon of {count} points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give at least 3 vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex {i} is at ({x:g}, {y:g})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give finite coordinates below {largest:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all points are the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give at least 3 different vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertices {i} and {j} are both at ({x:g}, {y:g})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all vertices lie on one line: the area is zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move a vertex off the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edges {first} and {second} cross or touch at ({x:g}, {y:g})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move or remove one of these vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex {i} all but touches edge {edge} at ({x:g}, {y:g})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move it away from the edge, or move the shape nearer to the coordinates&apos; origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the polygon all but touches itself near vertex {i}, at ({x:g}, {y:g})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move this vertex, or those next to it, apart</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Canvas</name>
    <message>
        <source>Draw the source shape here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the target shape here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to set each vertex; click the first one again to close.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press D for the drawing tool, or Ctrl+O to open a file.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Catch</name>
    <message>
        <source>vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level with a vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{angle}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grid</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with two empty canvases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project or a file of polygon pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export keyframes as SVG or PostScript</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring back what was undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all vertices of the shape last worked on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give up the gesture or the computation under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark vertices that correspond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;uggest Marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace all marks by ones that suggest themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Marks Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the marks as a table, to be edited by the keyboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show both shapes whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show both shapes larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show both shapes smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Star &amp;Pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the star pieces in the frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;keleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the skeleton in the frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Onion Skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show frames before and after as faint outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pat&amp;hs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the paths of the vertices through time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertex &amp;Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the numbers of the vertices, as the table of marks uses them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark writing on light ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light writing on dark ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the &amp;System</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speak the language of the system, from the next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speak English, from the next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Deutsch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speak German, from the next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to &amp;Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the source, t = 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to &amp;Target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the target, t = 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame &amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop, and show the frame before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame For&amp;ward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop, and show the next frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;xt Crossing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop where the next of the blends shown crosses itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compute Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute all blends anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select, move, scale, turn, insert and delete vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a shape vertex by vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Freehand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a shape by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw an ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regular &amp;Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a regular polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a star</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a letter or a text in outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to &amp;Vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let vertices catch the pointer, and their heights and sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to &amp;Edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let edges catch the pointer, and the lines that lengthen them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to &amp;15°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let edges catch at multiples of 15°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a grid and go from point to point of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the shape last worked on to the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the shape last worked on; other programs get it as SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a copied shape, or an SVG outline, on the canvas last worked on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy to &amp;Other Canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin the other shape with a copy of this one, marks and all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange source and target with their marks: the blend runs backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mirror Left and Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange left and right of the selection, or of the whole shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror &amp;Up and Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange above and below of the selection, or of the whole shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Simplify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out vertices that matter least; then adjust how far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;fine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add vertices evenly; then adjust how many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set First &amp;Vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the vertices count from the selected one on; it is drawn filled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Counts</name>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks went with this edit. Undo brings them back.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projects and polygon pairs (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “{name}”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Easing</name>
    <message>
        <source>Even</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ease in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ease out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ease in and out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linger at both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linger half-way</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EasingButton</name>
    <message>
        <source>Easing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Easing: how t runs over the time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EasingCurve</name>
    <message>
        <source>Easing curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a handle; arrow keys move it, Space takes the other one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EasingPopup</name>
    <message>
        <source>Easing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Keyframes in a row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A page for each keyframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All methods side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export keyframes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Star pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyframes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Time t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Faults</name>
    <message>
        <source>A fault in the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something went wrong inside the program. Your document is still here: save it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} was not written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to {path}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} was not saved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>Adjust the last step in the options above, or go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to set the first vertex; the new shape replaces the one on its canvas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click adds a vertex; the first vertex or Enter closes. Backspace takes one back, Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift makes a square; Ctrl suspends snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from corner to corner of its box. Shift makes a circle; Ctrl suspends snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from the middle to a corner. Shift turns by steps of 15°; Ctrl suspends snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from the middle to a point. Shift turns by steps of 15°; Ctrl suspends snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to draw the figure; Esc gives it up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press and draw the outline in one go; it closes itself. How closely it is followed is set above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to close the outline; Esc gives it up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a vertex, then its partner on the other canvas, or drag from one to the other. Click a pin to remove it, drag it to move it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the vertex that corresponds on the other canvas, or drag there; Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release on another vertex to move the pin there; Esc puts it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to set the vertices here; Esc puts them back. Ctrl suspends snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to keep it so; Esc puts it back. Shift keeps the proportions, or steps of 15°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag vertices or edges, click the shape to select it whole, double-click an edge to insert. Shift adds; arrow keys move, with Alt they turn and scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to select the vertices in the box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the text above, then click to set it. A canvas holds one outline: the largest, drawn solid.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Area drift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length drift</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes with the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarksModel</name>
    <message>
        <source>Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the numbers of two vertices that correspond</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarksPanel</name>
    <message>
        <source>How many marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace all marks by ones that suggest themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a vertex number to change it, Del removes. New marks go in the last row.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarksTable</name>
    <message>
        <source>Marks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures of the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Methods</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge-angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>star-skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stitched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rigid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>certified</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Numbers</name>
    <message>
        <source>X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle of the selection, from left to right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle of the selection, upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the selection was turned since it was selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OptionsBar</name>
    <message>
        <source>Options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices to add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PairDialog</name>
    <message>
        <source>Choose a pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds {count} pairs of shapes.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Panel</name>
    <message>
        <source>Verdict on {method}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{verdict} (out of date)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The in-between shapes appear here as soon as there are a source and a target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. F5 computes it again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>The red edges would cross or touch. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two vertices would be at the same place. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fault in the program, not in your shapes: {kind}: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This vertex already has {first}. Remove that pin first, or take another vertex.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{second} would cross {first}: going round, they come in different orders on the two shapes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{{second}} would cross {{first}}: going round from {third}, one of them comes first on the source, the other on the target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mark {label}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the new mark {label}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Side</name>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>What is being computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing {method}…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled; F5 computes again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Steering</name>
    <message>
        <source>Whole turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole turns of the star-skeleton on its way, counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual root</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the method choose the root again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Choose methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw freehand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw regular polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw star</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggest marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nudge vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set first vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy to other canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StripChart</name>
    <message>
        <source>Area, lengths and crossings over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drift of area and lengths, and where frames cross themselves. Click to go there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{method}: lies over itself, naturally, from t = {start:.2f} to {stop:.2f}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{method}: crosses itself from t = {start:.2f} to {stop:.2f}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TextPage</name>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Font</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimeSlider</name>
    <message>
        <source>Time, from source to target</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>At the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happens when the end is reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The moment shown, from 0 (source) to 1 (target)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TolerancePage</name>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{pixels} px</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>simple, area {area}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>natural crossing, area {area}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crosses at t = {t}, area {area}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area drifts by up to {p}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge lengths drift by {p} on average.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning angles drift by {a} degrees on average.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some edge has a negative length at t = {times}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never crosses itself: proven for every t.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frame crosses itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crosses itself at t = {times}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is natural: the shape lies over itself in layers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Natural in {n} of {all} frames: the shape lies over itself in layers.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
