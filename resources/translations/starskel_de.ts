<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name></name>
    <message>
        <source>animated SVG</source>
        <translation>animiertes SVG</translation>
    </message>
    <message>
        <source>{name} ends in &quot;{ending}&quot;</source>
        <translation>{name} endet auf „{ending}“</translation>
    </message>
    <message>
        <source>end it in {endings}</source>
        <translation>lassen Sie den Namen auf {endings} enden</translation>
    </message>
    <message>
        <source>one shape alone has nothing to become</source>
        <translation>eine Form allein hat nichts, in das sie übergehen könnte</translation>
    </message>
    <message>
        <source>keep two shapes at least</source>
        <translation>behalten Sie mindestens zwei Formen</translation>
    </message>
    <message>
        <source>a step this short cannot be seen</source>
        <translation>ein so kurzer Schritt ist nicht zu sehen</translation>
    </message>
    <message>
        <source>let it last longer</source>
        <translation>lassen Sie ihn länger dauern</translation>
    </message>
    <message>
        <source>the links name parts that are not there, or leave some out</source>
        <translation>die Verknüpfungen nennen Teile, die es nicht gibt, oder lassen welche aus</translation>
    </message>
    <message>
        <source>give each part a partner, or null where it has none</source>
        <translation>jedem Teil einen Partner geben, oder null, wo es keinen hat</translation>
    </message>
    <message>
        <source>there are marks, but not both shapes</source>
        <translation>es gibt Marken, aber nicht beide Formen</translation>
    </message>
    <message>
        <source>draw both shapes first</source>
        <translation>zeichnen Sie zuerst beide Formen</translation>
    </message>
    <message>
        <source>{count} vertices would be left, and a polygon has at least 3</source>
        <translation>{count} Eckpunkte blieben übrig, und ein Polygon hat mindestens 3</translation>
    </message>
    <message>
        <source>select all vertices to delete the whole shape</source>
        <translation>wählen Sie alle Eckpunkte aus, um die ganze Form zu löschen</translation>
    </message>
    <message>
        <source>the SVG declares entities</source>
        <translation>das SVG vereinbart Entitäten</translation>
    </message>
    <message>
        <source>save it as plain SVG</source>
        <translation>speichern Sie es als einfaches SVG</translation>
    </message>
    <message>
        <source>the SVG is damaged: {error}</source>
        <translation>das SVG ist beschädigt: {error}</translation>
    </message>
    <message>
        <source>there is no outline on the clipboard</source>
        <translation>in der Zwischenablage ist kein Umriss</translation>
    </message>
    <message>
        <source>copy a shape here, or a path in another program</source>
        <translation>kopieren Sie hier eine Form oder in einem anderen Programm einen Pfad</translation>
    </message>
    <message>
        <source>no blend without crossings was found: a shape is all but as narrow as rounding</source>
        <translation>es fand sich kein Übergang ohne Kreuzungen: eine Form ist fast so schmal wie die Rundung der Zahlen</translation>
    </message>
    <message>
        <source>widen its narrowest parts, or add marks</source>
        <translation>machen Sie ihre schmalsten Stellen breiter, oder setzen Sie weitere Marken</translation>
    </message>
    <message>
        <source>the edge from vertex {i} at ({x:g}, {y:g}) is too short for new vertices</source>
        <translation>die Kante ab Eckpunkt {i} bei ({x:g}, {y:g}) ist zu kurz für neue Eckpunkte</translation>
    </message>
    <message>
        <source>remove that vertex or mark more correspondences nearby</source>
        <translation>entfernen Sie diesen Eckpunkt, oder setzen Sie in der Nähe weitere Marken</translation>
    </message>
    <message>
        <source>the marks are not pairs of vertices</source>
        <translation>die Marken sind keine Paare von Eckpunkten</translation>
    </message>
    <message>
        <source>give each mark as (vertex of the source, vertex of the target), counted from 0</source>
        <translation>geben Sie jede Marke als (Eckpunkt der Quelle, Eckpunkt des Ziels) an, gezählt ab 0</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>mark {number} names vertex {vertex} of the {name}, which has {count}</source>
        <translation>Marke {number} nennt den Eckpunkt {vertex} ({name}); es gibt dort nur {count}</translation>
    </message>
    <message>
        <source>give a vertex from 0 to {last}</source>
        <translation>geben Sie einen Eckpunkt von 0 bis {last} an</translation>
    </message>
    <message>
        <source>marks {earlier} and {number} both name vertex {vertex} of the {name}</source>
        <translation>die Marken {earlier} und {number} nennen beide den Eckpunkt {vertex} ({name})</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>entfernen Sie eine davon</translation>
    </message>
    <message>
        <source>marks {first} {a} and {second} {b} come in one order round the source and in the other round the target</source>
        <translation>die Marken {first} {a} und {second} {b} folgen um die Quelle in der einen Reihenfolge aufeinander und um das Ziel in der anderen</translation>
    </message>
    <message>
        <source>remove or move one of them</source>
        <translation>entfernen oder verschieben Sie eines davon</translation>
    </message>
    <message>
        <source>{where}: {what}</source>
        <translation>{where}: {what}</translation>
    </message>
    <message>
        <source>{first} or {second}</source>
        <translation>{first} oder {second}</translation>
    </message>
    <message>
        <source>{path} cannot be read: {reason}</source>
        <translation>{path} kann nicht gelesen werden: {reason}</translation>
    </message>
    <message>
        <source>give the path of a readable file</source>
        <translation>wählen Sie eine Datei, die gelesen werden kann</translation>
    </message>
    <message>
        <source>{path} is no path</source>
        <translation>{path} ist kein Pfad</translation>
    </message>
    <message>
        <source>free some space there, or choose another disk</source>
        <translation>schaffen Sie dort Platz oder wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>choose a folder that exists and may be written to</source>
        <translation>wählen Sie einen vorhandenen Ordner, in den geschrieben werden darf</translation>
    </message>
    <message>
        <source>{path} cannot be written: {reason}</source>
        <translation>{path} kann nicht geschrieben werden: {reason}</translation>
    </message>
    <message>
        <source>choose a folder, or a place where one may be made</source>
        <translation>wählen Sie einen Ordner oder einen Ort, an dem einer angelegt werden darf</translation>
    </message>
    <message>
        <source>{path} cannot be made a folder: {reason}</source>
        <translation>{path} kann nicht als Ordner angelegt werden: {reason}</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>das ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>das ist kein Ordner</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger kann nur gelesen werden</translation>
    </message>
    <message>
        <source>{path} has the format &quot;{found}&quot;</source>
        <translation>{path} hat das Format „{found}“</translation>
    </message>
    <message>
        <source>{path} does not name its format</source>
        <translation>{path} nennt sein Format nicht</translation>
    </message>
    <message>
        <source>give a file of the format {names}</source>
        <translation>wählen Sie eine Datei des Formats {names}</translation>
    </message>
    <message>
        <source>{mend}, or open it with a newer starskel</source>
        <translation>{mend}, oder öffnen Sie sie mit einem neueren starskel</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>correct the file at this place</source>
        <translation>berichtigen Sie die Datei an dieser Stelle</translation>
    </message>
    <message>
        <source>{path} is damaged: {error}</source>
        <translation>{path} ist beschädigt: {error}</translation>
    </message>
    <message>
        <source>take an undamaged copy</source>
        <translation>nehmen Sie eine unbeschädigte Kopie</translation>
    </message>
    <message>
        <source>{path} has no pair &quot;{name}&quot;</source>
        <translation>{path} hat kein Paar „{name}“</translation>
    </message>
    <message>
        <source>{path}: pair &quot;{name}&quot;</source>
        <translation>{path}: Paar „{name}“</translation>
    </message>
    <message>
        <source>source (p)</source>
        <translation>Quelle (p)</translation>
    </message>
    <message>
        <source>target (q)</source>
        <translation>Ziel (q)</translation>
    </message>
    <message>
        <source>{where}: &quot;{name}&quot; is no file</source>
        <translation>{where}: „{name}“ ist keine Datei</translation>
    </message>
    <message>
        <source>give the name of a picture</source>
        <translation>geben Sie den Namen eines Bildes an</translation>
    </message>
    <message>
        <source>{where}: the picture &quot;{name}&quot; is not in the folder of the file</source>
        <translation>{where}: Das Bild „{name}“ liegt nicht im Ordner der Datei</translation>
    </message>
    <message>
        <source>put it beside the file and give its name alone</source>
        <translation>legen Sie es neben die Datei, und geben Sie nur seinen Namen an</translation>
    </message>
    <message>
        <source>{path}: the picture of shape {letter}</source>
        <translation>{path}: Das Bild der Form {letter}</translation>
    </message>
    <message>
        <source>choose one of {names}</source>
        <translation>wählen Sie eines von {names}</translation>
    </message>
    <message>
        <source>{path} holds no pair</source>
        <translation>{path} enthält kein Paar</translation>
    </message>
    <message>
        <source>give a file with at least one pair</source>
        <translation>wählen Sie eine Datei mit mindestens einem Paar</translation>
    </message>
    <message>
        <source>{path} has two pairs &quot;{name}&quot;</source>
        <translation>{path} hat zwei Paare „{name}“</translation>
    </message>
    <message>
        <source>rename one of them</source>
        <translation>benennen Sie eines davon um</translation>
    </message>
    <message>
        <source>{path} shows the method &quot;{name}&quot;, which this program does not know</source>
        <translation>{path} zeigt die Methode „{name}“, die dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>open it with a newer starskel, or name one of {names}</source>
        <translation>öffnen Sie es mit einem neueren starskel, oder nennen Sie eine von {names}</translation>
    </message>
    <message>
        <source>{path} shows the method &quot;{name}&quot; twice</source>
        <translation>{path} zeigt die Methode „{name}“ zweimal</translation>
    </message>
    <message>
        <source>name it once</source>
        <translation>nennen Sie sie einmal</translation>
    </message>
    <message>
        <source>{path} is a project of version {version}; this program knows versions up to {newest}</source>
        <translation>{path} ist ein Projekt der Version {version}; dieses Programm kennt Versionen bis {newest}</translation>
    </message>
    <message>
        <source>{name} has no shape {letter} yet</source>
        <translation>{name} hat noch keine Form {letter}</translation>
    </message>
    <message>
        <source>draw it in the editor and save</source>
        <translation>zeichnen Sie sie im Editor und speichern Sie</translation>
    </message>
    <message>
        <source>{path}: shape {letter}</source>
        <translation>{path}: Form {letter}</translation>
    </message>
    <message>
        <source>open it with a newer starskel</source>
        <translation>öffnen Sie es mit einem neueren starskel</translation>
    </message>
    <message>
        <source>{path} is a project of version {version}</source>
        <translation>{path} ist ein Projekt der Version {version}</translation>
    </message>
    <message>
        <source>versions count from 1</source>
        <translation>Versionen zählen ab 1</translation>
    </message>
    <message>
        <source>{path} has {shapes} shapes and {steps} steps</source>
        <translation>{path} hat {shapes} Formen und {steps} Schritte</translation>
    </message>
    <message>
        <source>give two shapes at least, and a step from each to the next</source>
        <translation>geben Sie mindestens zwei Formen an, und von jeder einen Schritt zur nächsten</translation>
    </message>
    <message>
        <source>{path} has {pictures} pictures for {shapes} shapes</source>
        <translation>{path} hat {pictures} Vorlagen für {shapes} Formen</translation>
    </message>
    <message>
        <source>give one for each shape, null where there is none</source>
        <translation>geben Sie für jede Form eine an, null, wo keine ist</translation>
    </message>
    <message>
        <source>{where}, part {number}</source>
        <translation>{where}, Teil {number}</translation>
    </message>
    <message>
        <source>{path}: step {first}-{last}</source>
        <translation>{path}: Schritt {first}-{last}</translation>
    </message>
    <message>
        <source>the points are not numbers</source>
        <translation>die Punkte sind keine Zahlen</translation>
    </message>
    <message>
        <source>give rows of x and y</source>
        <translation>geben Sie Zeilen aus x und y an</translation>
    </message>
    <message>
        <source>a polygon of {count} points</source>
        <translation>ein Polygon aus {count} Punkten</translation>
    </message>
    <message>
        <source>give at least 3 vertices</source>
        <translation>geben Sie mindestens 3 Eckpunkte an</translation>
    </message>
    <message>
        <source>vertex {i} is at ({x:g}, {y:g})</source>
        <translation>Eckpunkt {i} liegt bei ({x:g}, {y:g})</translation>
    </message>
    <message>
        <source>give finite coordinates below {largest:g}</source>
        <translation>geben Sie endliche Koordinaten unter {largest:g} an</translation>
    </message>
    <message>
        <source>all points are the same</source>
        <translation>alle Punkte sind gleich</translation>
    </message>
    <message>
        <source>give at least 3 different vertices</source>
        <translation>geben Sie mindestens 3 verschiedene Eckpunkte an</translation>
    </message>
    <message>
        <source>vertices {i} and {j} are both at ({x:g}, {y:g})</source>
        <translation>die Eckpunkte {i} und {j} liegen beide bei ({x:g}, {y:g})</translation>
    </message>
    <message>
        <source>all vertices lie on one line: the area is zero</source>
        <translation>alle Eckpunkte liegen auf einer Geraden: die Fläche ist null</translation>
    </message>
    <message>
        <source>move a vertex off the line</source>
        <translation>rücken Sie einen Eckpunkt von der Geraden weg</translation>
    </message>
    <message>
        <source>edges {first} and {second} cross or touch at ({x:g}, {y:g})</source>
        <translation>die Kanten {first} und {second} kreuzen oder berühren sich bei ({x:g}, {y:g})</translation>
    </message>
    <message>
        <source>move or remove one of these vertices</source>
        <translation>verschieben oder entfernen Sie einen dieser Eckpunkte</translation>
    </message>
    <message>
        <source>vertex {i} all but touches edge {edge} at ({x:g}, {y:g})</source>
        <translation>Eckpunkt {i} berührt bei ({x:g}, {y:g}) fast die Kante {edge}</translation>
    </message>
    <message>
        <source>move it away from the edge, or move the shape nearer to the coordinates&apos; origin</source>
        <translation>rücken Sie ihn von der Kante weg, oder die ganze Form näher an den Ursprung der Koordinaten</translation>
    </message>
    <message>
        <source>the polygon all but touches itself near vertex {i}, at ({x:g}, {y:g})</source>
        <translation>das Polygon berührt sich fast selbst, nahe Eckpunkt {i} bei ({x:g}, {y:g})</translation>
    </message>
    <message>
        <source>move this vertex, or those next to it, apart</source>
        <translation>rücken Sie diesen Eckpunkt oder seine Nachbarn auseinander</translation>
    </message>
    <message>
        <source>this is no picture, or of a kind that is not known here</source>
        <translation>das ist kein Bild, oder eines von einer Art, die hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>save it as PNG or JPEG</source>
        <translation>speichern Sie es als PNG oder JPEG</translation>
    </message>
    <message>
        <source>the new edge would cross or touch edge {edge}</source>
        <translation>die neue Kante würde die Kante {edge} kreuzen oder berühren</translation>
    </message>
    <message>
        <source>set the vertex elsewhere</source>
        <translation>setzen Sie den Eckpunkt woandershin</translation>
    </message>
    <message>
        <source>{count} methods do not go into one such file</source>
        <translation>{count} Methoden passen nicht in eine solche Datei</translation>
    </message>
    <message>
        <source>choose one method, and a file for each</source>
        <translation>wählen Sie eine Methode, und für jede eine eigene Datei</translation>
    </message>
    <message>
        <source>a geometry has coordinates beyond all numbers</source>
        <translation>eine Geometrie hat Koordinaten jenseits aller Zahlen</translation>
    </message>
    <message>
        <source>an open path was closed</source>
        <translation>ein offener Pfad wurde geschlossen</translation>
    </message>
    <message>
        <source>the GeoJSON</source>
        <translation>das GeoJSON</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>the GeoJSON is damaged: {error}</source>
        <translation>die GeoJSON-Datei ist beschädigt: {error}</translation>
    </message>
    <message>
        <source>shape {number}</source>
        <translation>Form {number}</translation>
    </message>
    <message>
        <source>features without an area were left out: {count}</source>
        <translation>Objekte ohne Fläche wurden weggelassen: {count}</translation>
    </message>
    <message>
        <source>the file is no GeoJSON</source>
        <translation>die Datei ist kein GeoJSON</translation>
    </message>
    <message>
        <source>give a file whose type is FeatureCollection</source>
        <translation>geben Sie eine Datei vom Typ FeatureCollection</translation>
    </message>
    <message>
        <source>it crossed or touched itself and was cut there</source>
        <translation>sie kreuzte oder berührte sich selbst und wurde dort zerschnitten</translation>
    </message>
    <message>
        <source>it was no proper area and was mended: {reason}</source>
        <translation>sie war keine gültige Fläche und wurde berichtigt: {reason}</translation>
    </message>
    <message>
        <source>parts of it touched and were moved apart</source>
        <translation>Teile von ihr berührten sich und wurden auseinandergerückt</translation>
    </message>
    <message>
        <source>a shape touches itself in too many places</source>
        <translation>eine Form berührt sich an zu vielen Stellen selbst</translation>
    </message>
    <message>
        <source>draw it with clearer gaps</source>
        <translation>zeichnen Sie sie mit deutlicheren Lücken</translation>
    </message>
    <message>
        <source>a ring</source>
        <translation>ein Ring</translation>
    </message>
    <message>
        <source>a part beyond all numbers was left out</source>
        <translation>ein Teil jenseits aller Zahlen wurde weggelassen</translation>
    </message>
    <message>
        <source>repeated vertices were left out</source>
        <translation>doppelte Eckpunkte wurden weggelassen</translation>
    </message>
    <message>
        <source>a part without an area was left out</source>
        <translation>ein Teil ohne Fläche wurde weggelassen</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>overlapping parts</source>
        <translation>überlappende Teile</translation>
    </message>
    <message>
        <source>crossings</source>
        <translation>Kreuzungen</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>give a file that ends in {endings}</source>
        <translation>geben Sie eine Datei, die auf {endings} endet</translation>
    </message>
    <message>
        <source>{path} holds no shape</source>
        <translation>{path} enthält keine Form</translation>
    </message>
    <message>
        <source>give a file with at least one closed outline</source>
        <translation>geben Sie eine Datei mit mindestens einem geschlossenen Umriss an</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>the file is no SVG</source>
        <translation>die Datei ist kein SVG</translation>
    </message>
    <message>
        <source>{what} in the file were left out</source>
        <translation>{what} in der Datei wurden weggelassen</translation>
    </message>
    <message>
        <source>it is the outline of a stroke</source>
        <translation>sie ist der Umriss eines Strichs</translation>
    </message>
    <message>
        <source>geometry {number} of the WKT is damaged: {error}</source>
        <translation>Geometrie {number} der WKT-Datei ist beschädigt: {error}</translation>
    </message>
    <message>
        <source>geometries without an area were left out: {count}</source>
        <translation>Geometrien ohne Fläche wurden weggelassen: {count}</translation>
    </message>
    <message>
        <source>the WKT</source>
        <translation>das WKT</translation>
    </message>
    <message>
        <source>brackets</source>
        <translation>Klammern</translation>
    </message>
    <message>
        <source>words</source>
        <translation>Wörter</translation>
    </message>
    <message>
        <source>the file is no WKT</source>
        <translation>die Datei ist kein WKT</translation>
    </message>
    <message>
        <source>nested brackets</source>
        <translation>verschachtelte Klammern</translation>
    </message>
    <message>
        <source>give text that begins like &quot;POLYGON ((0 0, &quot;</source>
        <translation>geben Sie Text, der wie „POLYGON ((0 0, “ beginnt</translation>
    </message>
    <message>
        <source>{name} is no picture, or of a kind that is not known here</source>
        <translation>{name} ist kein Bild, oder eines von unbekannter Art</translation>
    </message>
    <message>
        <source>save it as {kinds}</source>
        <translation>speichern Sie es als {kinds}</translation>
    </message>
    <message>
        <source>many more</source>
        <translation>viele weitere</translation>
    </message>
    <message>
        <source>{width} × {height}</source>
        <translation>{width} × {height}</translation>
    </message>
    <message>
        <source>{count} times {width} × {height}</source>
        <translation>{count}-mal {width} × {height}</translation>
    </message>
    <message>
        <source>an animation has too many pixels: {size}</source>
        <translation>eine Animation hat zu viele Pixel: {size}</translation>
    </message>
    <message>
        <source>take fewer or smaller pictures, at most {most} pixels, or MP4</source>
        <translation>nehmen Sie weniger oder kleinere Bilder mit höchstens {most} Pixeln, oder MP4</translation>
    </message>
    <message>
        <source>{name} has too many pixels: {size}</source>
        <translation>{name} hat zu viele Pixel: {size}</translation>
    </message>
    <message>
        <source>scale it down to at most {most} pixels, {side} a side</source>
        <translation>verkleinern Sie es auf höchstens {most} Pixel, {side} je Seite</translation>
    </message>
    <message>
        <source>{name} is damaged: {error}</source>
        <translation>{name} ist beschädigt: {error}</translation>
    </message>
    <message>
        <source>writing {ending} needs PyAV</source>
        <translation>um {ending} zu schreiben, wird PyAV gebraucht</translation>
    </message>
    <message>
        <source>install it: pip install &quot;starskel[video]&quot;</source>
        <translation>installieren Sie es: pip install &quot;starskel[video]&quot;</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>deckend</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>nothing in the picture is {what} enough at a level of {level:g}</source>
        <translation>nichts im Bild ist bei einer Schwelle von {level:g} {what} genug</translation>
    </message>
    <message>
        <source>choose another level, or trace something else</source>
        <translation>wählen Sie eine andere Schwelle, oder zeichnen Sie etwas anderes nach</translation>
    </message>
    <message>
        <source>the outline has {count} vertices</source>
        <translation>der Umriss hat {count} Eckpunkte</translation>
    </message>
    <message>
        <source>choose a larger tolerance: {most} are the most</source>
        <translation>wählen Sie eine größere Toleranz: höchstens {most} sind möglich</translation>
    </message>
    <message>
        <source>the outline changes direction at {count} places</source>
        <translation>der Umriss ändert an {count} Stellen die Richtung</translation>
    </message>
    <message>
        <source>smooth the picture or scale it down: {most} are the most</source>
        <translation>glätten Sie das Bild, oder verkleinern Sie es: höchstens {most}</translation>
    </message>
    <message>
        <source>pairing</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>a picture of {width} × {height} pixels is too large</source>
        <translation>ein Bild von {width} × {height} Pixeln ist zu groß</translation>
    </message>
    <message>
        <source>take fewer: at most {most}, {side} a side</source>
        <translation>nehmen Sie weniger: höchstens {most}, {side} je Seite</translation>
    </message>
    <message>
        <source>the font is damaged, or of a kind that is not known here</source>
        <translation>die Schrift ist beschädigt, oder von einer Art, die hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>give a TrueType or OpenType font</source>
        <translation>geben Sie eine TrueType- oder OpenType-Schrift an</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; has no outline</source>
        <translation>„{text}“ hat keinen Umriss</translation>
    </message>
    <message>
        <source>the font has no letter &quot;{letter}&quot;</source>
        <translation>die Schrift hat keinen Buchstaben „{letter}“</translation>
    </message>
    <message>
        <source>leave it out, or take another font</source>
        <translation>lassen Sie ihn weg, oder nehmen Sie eine andere Schrift</translation>
    </message>
    <message>
        <source>a text is empty</source>
        <translation>ein Text ist leer</translation>
    </message>
    <message>
        <source>give at least one letter</source>
        <translation>geben Sie mindestens einen Buchstaben an</translation>
    </message>
    <message>
        <source>what is opaque was traced</source>
        <translation>nachgezeichnet wurde, was undurchsichtig ist</translation>
    </message>
    <message>
        <source>what is dark was traced</source>
        <translation>nachgezeichnet wurde, was dunkel ist</translation>
    </message>
    <message>
        <source>what is light was traced</source>
        <translation>nachgezeichnet wurde, was hell ist</translation>
    </message>
    <message>
        <source>silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>edges beside each other</source>
        <translation>Kanten nebeneinander</translation>
    </message>
    <message>
        <source>{name} has {count} {what}</source>
        <translation>{name}: {count} {what}</translation>
    </message>
    <message>
        <source>give a file with at most {most} {what}</source>
        <translation>geben Sie eine andere Datei an; erlaubt sind höchstens {most} {what}</translation>
    </message>
    <message>
        <source>{count} {what}, and at most {most}</source>
        <translation>{count} {what}, erlaubt sind höchstens {most}</translation>
    </message>
    <message>
        <source>the picture could not be traced</source>
        <translation>das Bild konnte nicht nachgezeichnet werden</translation>
    </message>
    <message>
        <source>take another picture</source>
        <translation>nehmen Sie ein anderes Bild</translation>
    </message>
    <message>
        <source>a fault in the program ended the computation</source>
        <translation>ein Fehler im Programm hat die Berechnung beendet</translation>
    </message>
    <message>
        <source>change the shapes a little, or press F5</source>
        <translation>ändern Sie die Formen ein wenig, oder drücken Sie F5</translation>
    </message>
    <message>
        <source>the SVG</source>
        <translation>das SVG</translation>
    </message>
    <message>
        <source>tags</source>
        <translation>Tags</translation>
    </message>
    <message>
        <source>elements and subpaths</source>
        <translation>Elemente und Teilpfade</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>Buchstaben</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>the SVG is nested too deeply, or uses itself</source>
        <translation>das SVG ist zu tief verschachtelt oder benutzt sich selbst</translation>
    </message>
    <message>
        <source>nest at most {most} elements</source>
        <translation>verschachteln Sie höchstens {most} Elemente</translation>
    </message>
    <message>
        <source>{value:g} is no {what}</source>
        <translation>{value:g} ist keine {what}</translation>
    </message>
    <message>
        <source>give one from {least:g} to {most:g}</source>
        <translation>eine von {least:g} bis {most:g} angeben</translation>
    </message>
    <message>
        <source>number of frames</source>
        <translation>Anzahl von Bildern</translation>
    </message>
    <message>
        <source>number of seconds</source>
        <translation>Dauer in Sekunden</translation>
    </message>
    <message>
        <source>number of pictures a second</source>
        <translation>Zahl von Bildern je Sekunde</translation>
    </message>
    <message>
        <source>number of pixels a side</source>
        <translation>Zahl von Pixeln je Seite</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>size in points</source>
        <translation>Größe in Punkten</translation>
    </message>
    <message>
        <source>distance in points</source>
        <translation>Entfernung in Punkten</translation>
    </message>
    <message>
        <source>width in points</source>
        <translation>Breite in Punkten</translation>
    </message>
    <message>
        <source>ring {number}</source>
        <translation>Ring {number}</translation>
    </message>
    <message>
        <source>ring {hole}, a hole, does not lie inside ring {outline}</source>
        <translation>Ring {hole}, ein Loch, liegt nicht in Ring {outline}</translation>
    </message>
    <message>
        <source>move it, or give it as a part</source>
        <translation>verschieben Sie ihn oder machen Sie ihn zu einem Teil</translation>
    </message>
    <message>
        <source>rings {first} and {second}, holes of one part, meet</source>
        <translation>die Ringe {first} und {second}, Löcher eines Teils, berühren sich</translation>
    </message>
    <message>
        <source>join them to one hole, or move them apart</source>
        <translation>verbinden Sie sie zu einem Loch oder schieben Sie sie auseinander</translation>
    </message>
    <message>
        <source>all parts are hidden</source>
        <translation>alle Teile sind ausgeblendet</translation>
    </message>
    <message>
        <source>show at least one of them</source>
        <translation>mindestens eines von ihnen einblenden</translation>
    </message>
    <message>
        <source>nothing can be written in {path}</source>
        <translation>in {path} kann nichts geschrieben werden</translation>
    </message>
    <message>
        <source>make room on its disk, and let files be written there</source>
        <translation>schaffen Sie Platz auf dem Datenträger, und lassen Sie das Schreiben dort zu</translation>
    </message>
    <message>
        <source>a path</source>
        <translation>ein Pfad</translation>
    </message>
    <message>
        <source>no bridges lead to the holes of a part: somewhere it is all but as narrow as rounding</source>
        <translation>keine Brücken führen zu den Löchern eines Teils: irgendwo ist er fast so schmal wie das Runden</translation>
    </message>
    <message>
        <source>widen its narrowest places, or pair the holes otherwise</source>
        <translation>verbreitern Sie die engsten Stellen oder paaren Sie die Löcher anders</translation>
    </message>
    <message>
        <source>the rings paired as {ring} lie in those paired as {other}, but not in the {name}: they must meet on the way</source>
        <translation>die Ringe, die als {ring} gepaart sind, liegen in denen von {other}, aber nicht in {name}: sie müssen sich unterwegs treffen</translation>
    </message>
    <message>
        <source>pair them otherwise, place what grows or shrinks elsewhere, or choose another method</source>
        <translation>paaren Sie sie anders, setzen Sie anderswohin, was wächst oder schrumpft, oder wählen Sie eine andere Methode</translation>
    </message>
    <message>
        <source>{what} at t = {t:.3f}, and no way round was found</source>
        <translation>bei t = {t:.3f}: {what}, und kein Weg herum wurde gefunden</translation>
    </message>
    <message>
        <source>choose another method, such as stitched, add marks, or widen the narrowest places</source>
        <translation>wählen Sie eine andere Methode wie „vernäht“, setzen Sie mehr Marken oder verbreitern Sie die engsten Stellen</translation>
    </message>
    <message>
        <source>two rings come too near to each other</source>
        <translation>zwei Ringe kommen einander zu nahe</translation>
    </message>
    <message>
        <source>the ring paired as {ring} crosses itself</source>
        <translation>der Ring, der als {ring} gepaart ist, kreuzt sich selbst</translation>
    </message>
    <message>
        <source>the rings paired as {ring} and {other} meet</source>
        <translation>die Ringe, die als {ring} und {other} gepaart sind, treffen sich</translation>
    </message>
    <message>
        <source>a part is to become several, but no straight cut leaves its holes whole and where they belong</source>
        <translation>ein Teil soll zu mehreren werden, aber kein gerader Schnitt lässt seine Löcher ganz und dort, wohin sie gehören</translation>
    </message>
    <message>
        <source>pair it with one part, and let the others grow from points</source>
        <translation>paaren Sie ihn mit einem Teil und lassen Sie die anderen aus Punkten wachsen</translation>
    </message>
    <message>
        <source>rings {i} and {j} bear marks, but one of them is cut into parts</source>
        <translation>die Ringe {i} und {j} tragen Marken, aber einer von ihnen wird in Teile geschnitten</translation>
    </message>
    <message>
        <source>remove these marks, or cut the ring yourself</source>
        <translation>entfernen Sie diese Marken oder schneiden Sie den Ring selbst</translation>
    </message>
    <message>
        <source>ring {ring} of the {name} has partners, and is alone besides</source>
        <translation>Ring {ring} ({name}) hat Partner und steht außerdem allein</translation>
    </message>
    <message>
        <source>remove one of these pairs</source>
        <translation>entfernen Sie eines dieser Paare</translation>
    </message>
    <message>
        <source>ring {ring} of the {name} and ring {other} of the {other_name} both have several partners</source>
        <translation>Ring {ring} ({name}) und Ring {other} ({other_name}) haben beide mehrere Partner</translation>
    </message>
    <message>
        <source>let one ring become several, or several one</source>
        <translation>lassen Sie einen Ring zu mehreren werden oder mehrere zu einem</translation>
    </message>
    <message>
        <source>holes {i} and {j} are paired, but what they are holes in is not</source>
        <translation>die Löcher {i} und {j} sind gepaart, aber das, worin sie Löcher sind, ist es nicht</translation>
    </message>
    <message>
        <source>pair their outlines, or let one close to a point and the other grow from one</source>
        <translation>paaren Sie ihre Umrisse oder lassen Sie eines zu einem Punkt schrumpfen und das andere aus einem wachsen</translation>
    </message>
    <message>
        <source>rings {i} and {j} are paired, but one is an outline and the other a hole</source>
        <translation>die Ringe {i} und {j} sind gepaart, aber einer ist ein Umriss und der andere ein Loch</translation>
    </message>
    <message>
        <source>pair outlines with outlines and holes with holes</source>
        <translation>paaren Sie Umrisse mit Umrissen und Löcher mit Löchern</translation>
    </message>
    <message>
        <source>{name} would be a point at ({x:g}, {y:g}), which is not inside its part</source>
        <translation>{name} wäre ein Punkt bei ({x:g}, {y:g}), der nicht in seinem Teil liegt</translation>
    </message>
    <message>
        <source>choose a place inside the part and outside its other holes</source>
        <translation>wählen Sie einen Ort im Teil und außerhalb seiner anderen Löcher</translation>
    </message>
    <message>
        <source>set marks between them, or simplify the shapes</source>
        <translation>setzen Sie Marken dazwischen oder vereinfachen Sie die Formen</translation>
    </message>
    <message>
        <source>pairs of vertices to be compared</source>
        <translation>zu vergleichende Paare von Eckpunkten</translation>
    </message>
    <message>
        <source>simplify the shapes, or take a method that needs no pieces</source>
        <translation>vereinfachen Sie die Formen oder nehmen Sie eine Methode ohne Teile</translation>
    </message>
    <message>
        <source>vertices to be cut into pieces</source>
        <translation>in Teile zu zerlegende Eckpunkte</translation>
    </message>
    <message>
        <source>all that is to be seen is a point</source>
        <translation>alles, was zu sehen wäre, ist ein Punkt</translation>
    </message>
    <message>
        <source>choose other times</source>
        <translation>wählen Sie andere Zeiten</translation>
    </message>
    <message>
        <source>the blend jumps</source>
        <translation>der Übergang springt</translation>
    </message>
    <message>
        <source>take a larger tolerance, or another method</source>
        <translation>nehmen Sie eine größere Toleranz oder eine andere Methode</translation>
    </message>
</context>
<context>
    <name>AboutDialog</name>
    <message>
        <source>About starskel</source>
        <translation>Über starskel</translation>
    </message>
    <message>
        <source>Blends one drawn shape into another by the star-skeleton, after M. Shapira and A. Rappoport, IEEE Computer Graphics and Applications, March 1995. MIT licence.</source>
        <translation>Überführt eine gezeichnete Form durch das Sternskelett in eine andere, nach M. Shapira und A. Rappoport, IEEE Computer Graphics and Applications, März 1995. MIT-Lizenz.</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>&amp;Copy Versions</source>
        <translation>Versionen &amp;kopieren</translation>
    </message>
</context>
<context>
    <name>Beginning</name>
    <message>
        <source>Put this away; it is in the Help menu</source>
        <translation>Schließen; steht auch im Menü Hilfe</translation>
    </message>
    <message>
        <source>Put away how to begin</source>
        <translation>Erste Schritte schließen</translation>
    </message>
    <message>
        <source>{keys}, then click a vertex and the one that it becomes.</source>
        <translation>{keys}, dann einen Eckpunkt anklicken und den, zu dem er wird.</translation>
    </message>
    <message>
        <source>{keys} writes keyframes, an animation or numbers.</source>
        <translation>{keys} schreibt Schlüsselbilder, eine Animation oder Zahlen.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>New, then set the corners of both shapes; or open an example.</source>
        <translation>Neu, dann die Eckpunkte beider Formen setzen; oder ein Beispiel öffnen.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>{keys} plays; drag the slider to any moment.</source>
        <translation>{keys} spielt ab; der Regler führt zu jedem Augenblick.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>All methods side by side: does a blend cross itself?</source>
        <translation>Alle Methoden nebeneinander: schneidet sich ein Übergang?</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
</context>
<context>
    <name>Canvas</name>
    <message>
        <source>Draw shape {letter} here</source>
        <translation>Zeichnen Sie hier die Form {letter}</translation>
    </message>
    <message>
        <source>Draw the source shape here</source>
        <translation>Zeichnen Sie hier die Quelle</translation>
    </message>
    <message>
        <source>Draw the target shape here</source>
        <translation>Zeichnen Sie hier das Ziel</translation>
    </message>
    <message>
        <source>Trace the outline of the picture, in the Shape menu, or draw over it.</source>
        <translation>Den Umriss des Bildes nachzeichnen lassen, im Menü Form, oder darüber zeichnen.</translation>
    </message>
    <message>
        <source>Draw the new part here</source>
        <translation>Hier das neue Teil zeichnen</translation>
    </message>
    <message>
        <source>Draw its partner here, or leave it to grow from a point</source>
        <translation>Hier seinen Partner zeichnen, oder es bei einem Punkt lassen</translation>
    </message>
    <message>
        <source>Click to set each vertex; click the first one again to close.</source>
        <translation>Jeder Klick setzt einen Eckpunkt; ein Klick auf den ersten schließt die Form.</translation>
    </message>
    <message>
        <source>Take a tool from the left, drop a picture to draw over, or open a file.</source>
        <translation>Nehmen Sie links ein Werkzeug, ziehen Sie eine Vorlage zum Nachzeichnen hierher, oder öffnen Sie eine Datei.</translation>
    </message>
</context>
<context>
    <name>Catch</name>
    <message>
        <source>vertex</source>
        <translation>Eckpunkt</translation>
    </message>
    <message>
        <source>level with a vertex</source>
        <translation>auf Höhe eines Eckpunkts</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>{angle}°</source>
        <translation>{angle}°</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Gitter</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Start with two empty canvases</source>
        <translation>Mit zwei leeren Flächen beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Reco&amp;vered Documents…</source>
        <translation>&amp;Gerettete Dokumente…</translation>
    </message>
    <message>
        <source>Open unsaved work that a crash has left behind</source>
        <translation>Ungespeicherte Arbeit öffnen, die ein Absturz hinterlassen hat</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Das Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last edit</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Bring back what was undone</source>
        <translation>Das Zurückgenommene wiederbringen</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Alle&amp;s auswählen</translation>
    </message>
    <message>
        <source>Select the part last worked on; once more, all parts of its shape</source>
        <translation>Wählt das zuletzt bearbeitete Teil aus, noch einmal alle Teile seiner Form</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected vertices</source>
        <translation>Die ausgewählten Eckpunkte löschen</translation>
    </message>
    <message>
        <source>Give up the gesture or the computation under way</source>
        <translation>Die begonnene Bewegung oder die laufende Berechnung abbrechen</translation>
    </message>
    <message>
        <source>&amp;Mark</source>
        <translation>&amp;Marken</translation>
    </message>
    <message>
        <source>Mark vertices that correspond</source>
        <translation>Eckpunkte markieren, die einander entsprechen</translation>
    </message>
    <message>
        <source>S&amp;uggest Marks</source>
        <translation>Marken &amp;vorschlagen</translation>
    </message>
    <message>
        <source>Replace all marks by ones that suggest themselves</source>
        <translation>Alle Marken durch vorgeschlagene ersetzen</translation>
    </message>
    <message>
        <source>Show the marks as a table, to be edited by the keyboard</source>
        <translation>Die Marken als Tabelle zeigen, die sich mit der Tastatur bearbeiten lässt</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Show both shapes whole</source>
        <translation>Beide Formen ganz zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Show both shapes larger</source>
        <translation>Beide Formen größer zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Show both shapes smaller</source>
        <translation>Beide Formen kleiner zeigen</translation>
    </message>
    <message>
        <source>Star &amp;Pieces</source>
        <translation>Stern-S&amp;tücke</translation>
    </message>
    <message>
        <source>Show the star pieces in the frames</source>
        <translation>Die Stern-Stücke in den Zwischenbildern zeigen</translation>
    </message>
    <message>
        <source>S&amp;keleton</source>
        <translation>&amp;Skelett</translation>
    </message>
    <message>
        <source>Show the skeleton in the frames</source>
        <translation>Das Skelett in den Zwischenbildern zeigen</translation>
    </message>
    <message>
        <source>Onion &amp;Skin</source>
        <translation>Z&amp;wiebelhaut</translation>
    </message>
    <message>
        <source>Pi&amp;ctures in the Shapes</source>
        <translation>Bilder i&amp;n den Formen</translation>
    </message>
    <message>
        <source>Show the pictures in the frames, the one fading into the other</source>
        <translation>Die Bilder in den Zwischenformen zeigen, wie eines ins andere übergeht</translation>
    </message>
    <message>
        <source>Language of the S&amp;ystem</source>
        <translation>Sprache des S&amp;ystems</translation>
    </message>
    <message>
        <source>De&amp;utsch</source>
        <translation>De&amp;utsch</translation>
    </message>
    <message>
        <source>&amp;Parts</source>
        <translation>&amp;Teile</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Show frames before and after as faint outlines</source>
        <translation>Zwischenbilder davor und danach als blasse Umrisse zeigen</translation>
    </message>
    <message>
        <source>Open a project, a file of polygon pairs, or shapes of a drawing</source>
        <translation>Ein Projekt, eine Datei mit Polygonpaaren oder Formen einer Zeichnung öffnen</translation>
    </message>
    <message>
        <source>&amp;Import Shapes…</source>
        <translation>Formen &amp;importieren …</translation>
    </message>
    <message>
        <source>Take shapes of an SVG, a map, a picture or a font onto the canvases</source>
        <translation>Formen einer SVG-Datei, Karte, eines Bildes oder einer Schrift auf die Zeichenflächen holen</translation>
    </message>
    <message>
        <source>Export keyframes, an animation or numbers</source>
        <translation>Schlüsselbilder, eine Animation oder Zahlen exportieren</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Marks Ta&amp;ble</source>
        <translation>Marken-Ta&amp;belle</translation>
    </message>
    <message>
        <source>Pat&amp;hs</source>
        <translation>&amp;Bahnen</translation>
    </message>
    <message>
        <source>Show the paths of the vertices through time</source>
        <translation>Die Bahnen der Eckpunkte durch die Zeit zeigen</translation>
    </message>
    <message>
        <source>Vertex &amp;Numbers</source>
        <translation>Nummern der &amp;Eckpunkte</translation>
    </message>
    <message>
        <source>Show the numbers of the vertices, as the table of marks uses them</source>
        <translation>Die Eckpunkte so nummeriert zeigen, wie die Marken-Tabelle sie nennt</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark writing on light ground</source>
        <translation>Dunkle Schrift auf hellem Grund</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light writing on dark ground</source>
        <translation>Helle Schrift auf dunklem Grund</translation>
    </message>
    <message>
        <source>Speak the language of the system, from the next start on</source>
        <translation>Die Sprache des Systems sprechen, vom nächsten Start an</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>Eng&amp;lish</translation>
    </message>
    <message>
        <source>Speak English, from the next start on</source>
        <translation>Englisch sprechen, vom nächsten Start an</translation>
    </message>
    <message>
        <source>Speak German, from the next start on</source>
        <translation>Deutsch sprechen, vom nächsten Start an</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play or pause; so does a tap of Space</source>
        <translation>Abspielen oder anhalten, auch durch Tippen der Leertaste</translation>
    </message>
    <message>
        <source>Go to &amp;Source</source>
        <translation>Zur &amp;Quelle</translation>
    </message>
    <message>
        <source>Show the source, t = 0</source>
        <translation>Die Quelle zeigen, t = 0</translation>
    </message>
    <message>
        <source>Go to &amp;Target</source>
        <translation>Zum &amp;Ziel</translation>
    </message>
    <message>
        <source>Show the target, t = 1</source>
        <translation>Das Ziel zeigen, t = 1</translation>
    </message>
    <message>
        <source>Frame &amp;Back</source>
        <translation>Zwischenbild z&amp;urück</translation>
    </message>
    <message>
        <source>Stop, and show the frame before</source>
        <translation>Anhalten und das vorige Zwischenbild zeigen</translation>
    </message>
    <message>
        <source>Frame For&amp;ward</source>
        <translation>Zwischenbild v&amp;or</translation>
    </message>
    <message>
        <source>Stop, and show the next frame</source>
        <translation>Anhalten und das nächste Zwischenbild zeigen</translation>
    </message>
    <message>
        <source>Ne&amp;xt Crossing</source>
        <translation>Nächste &amp;Kreuzung</translation>
    </message>
    <message>
        <source>Stop where the next of the blends shown crosses itself</source>
        <translation>Dort anhalten, wo sich der nächste der gezeigten Übergänge kreuzt</translation>
    </message>
    <message>
        <source>&amp;Compute Again</source>
        <translation>&amp;Neu berechnen</translation>
    </message>
    <message>
        <source>Compute all blends anew</source>
        <translation>Alle Übergänge neu berechnen</translation>
    </message>
    <message>
        <source>How to &amp;Begin</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>Show in five lines how to begin</source>
        <translation>In fünf Zeilen zeigen, wie es losgeht</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Shape</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>Se&amp;quence</source>
        <translation>F&amp;olge</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Über&amp;gang</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Select, move, scale, turn, insert and delete vertices</source>
        <translation>Eckpunkte auswählen, verschieben, skalieren, drehen, einfügen und löschen</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Zeichnen</translation>
    </message>
    <message>
        <source>Draw a shape vertex by vertex</source>
        <translation>Eine Form Eckpunkt für Eckpunkt zeichnen</translation>
    </message>
    <message>
        <source>&amp;Freehand</source>
        <translation>&amp;Freihand</translation>
    </message>
    <message>
        <source>Draw a shape by hand</source>
        <translation>Eine Form von Hand zeichnen</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>Draw a rectangle</source>
        <translation>Ein Rechteck zeichnen</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>Draw an ellipse</source>
        <translation>Eine Ellipse zeichnen</translation>
    </message>
    <message>
        <source>Regular &amp;Polygon</source>
        <translation>Rege&amp;lmäßiges Vieleck</translation>
    </message>
    <message>
        <source>Draw a regular polygon</source>
        <translation>Ein regelmäßiges Vieleck zeichnen</translation>
    </message>
    <message>
        <source>S&amp;tar</source>
        <translation>&amp;Stern</translation>
    </message>
    <message>
        <source>Draw a star</source>
        <translation>Einen Stern zeichnen</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>&amp;Text</translation>
    </message>
    <message>
        <source>Set a letter or a text in outlines</source>
        <translation>Einen Buchstaben oder einen Text als Umriss setzen</translation>
    </message>
    <message>
        <source>P&amp;icture</source>
        <translation>V&amp;orlage</translation>
    </message>
    <message>
        <source>Place a picture behind a shape, to draw over it</source>
        <translation>Ein Bild hinter eine Form legen, um es nachzuzeichnen</translation>
    </message>
    <message>
        <source>Snap to &amp;Vertices</source>
        <translation>An E&amp;ckpunkten einrasten</translation>
    </message>
    <message>
        <source>Let vertices catch the pointer, and their heights and sides</source>
        <translation>Der Zeiger rastet an Eckpunkten ein, und auf gleicher Höhe mit ihnen</translation>
    </message>
    <message>
        <source>S&amp;nap to Edges</source>
        <translation>An &amp;Kanten einrasten</translation>
    </message>
    <message>
        <source>Let edges catch the pointer, and the lines that lengthen them</source>
        <translation>Der Zeiger rastet an Kanten ein, und an ihren Verlängerungen</translation>
    </message>
    <message>
        <source>Snap to &amp;15°</source>
        <translation>Bei &amp;15° einrasten</translation>
    </message>
    <message>
        <source>Let edges catch at multiples of 15°</source>
        <translation>Kanten rasten bei Vielfachen von 15° ein</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation>Am &amp;Gitter einrasten</translation>
    </message>
    <message>
        <source>Show a grid and go from point to point of it</source>
        <translation>Ein Gitter zeigen und auf ihm von Punkt zu Punkt gehen</translation>
    </message>
    <message>
        <source>Cu&amp;t Shape</source>
        <translation>Form &amp;ausschneiden</translation>
    </message>
    <message>
        <source>Take the selected parts, or the whole shape, to the clipboard</source>
        <translation>Ausgewählte Teile oder die ganze Form in die Zwischenablage nehmen</translation>
    </message>
    <message>
        <source>Copy the selected parts with their holes, or the whole shape; as SVG, too</source>
        <translation>Ausgewählte Teile mit ihren Löchern oder die ganze Form kopieren, auch als SVG</translation>
    </message>
    <message>
        <source>Put a copied shape in place of the one last worked on, or add copied parts</source>
        <translation>Eine kopierte Form an die Stelle der zuletzt bearbeiteten setzen oder kopierte Teile anfügen</translation>
    </message>
    <message>
        <source>&amp;Copy Shape</source>
        <translation>Form &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste Shape</source>
        <translation>Form &amp;einfügen</translation>
    </message>
    <message>
        <source>Copy to &amp;Other Canvas</source>
        <translation>Auf die &amp;andere Fläche kopieren</translation>
    </message>
    <message>
        <source>Begin the other shape with a copy of this one, marks and all</source>
        <translation>Die andere Form mit einer Kopie von dieser beginnen, samt Marken</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Exchange source and target with their marks: the blend runs backwards</source>
        <translation>Quelle und Ziel mit ihren Marken vertauschen: der Übergang läuft rückwärts</translation>
    </message>
    <message>
        <source>&amp;Mirror Left and Right</source>
        <translation>&amp;Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>Exchange left and right of the selection, or of the whole shape</source>
        <translation>Links und rechts der Auswahl vertauschen, oder der ganzen Form</translation>
    </message>
    <message>
        <source>Mirror &amp;Up and Down</source>
        <translation>&amp;Oben und unten spiegeln</translation>
    </message>
    <message>
        <source>Exchange above and below of the selection, or of the whole shape</source>
        <translation>Oben und unten der Auswahl vertauschen, oder der ganzen Form</translation>
    </message>
    <message>
        <source>&amp;Simplify</source>
        <translation>&amp;Vereinfachen</translation>
    </message>
    <message>
        <source>Leave out vertices that matter least; then adjust how far</source>
        <translation>Die unwichtigsten Eckpunkte weglassen; danach lässt sich einstellen, wie viele</translation>
    </message>
    <message>
        <source>Re&amp;fine</source>
        <translation>Ver&amp;feinern</translation>
    </message>
    <message>
        <source>Add vertices evenly; then adjust how many</source>
        <translation>Gleichmäßig Eckpunkte hinzufügen; danach lässt sich einstellen, wie viele</translation>
    </message>
    <message>
        <source>Set First &amp;Vertex</source>
        <translation>&amp;Ersten Eckpunkt festlegen</translation>
    </message>
    <message>
        <source>Let the vertices count from the selected one on; it is drawn filled</source>
        <translation>Die Eckpunkte vom ausgewählten an zählen; er wird gefüllt gezeichnet</translation>
    </message>
    <message>
        <source>Open P&amp;icture…</source>
        <translation>&amp;Bildvorlage öffnen…</translation>
    </message>
    <message>
        <source>Put a picture behind the shape last worked on</source>
        <translation>Ein Bild hinter die zuletzt bearbeitete Form legen</translation>
    </message>
    <message>
        <source>&amp;Trace Outline…</source>
        <translation>Umriss na&amp;chzeichnen…</translation>
    </message>
    <message>
        <source>Draw the shape along the edge of what is seen in the picture</source>
        <translation>Die Form am Rand dessen zeichnen, was auf der Vorlage zu sehen ist</translation>
    </message>
    <message>
        <source>&amp;Lock Picture</source>
        <translation>Vorlage &amp;sperren</translation>
    </message>
    <message>
        <source>Let the picture stay where it is</source>
        <translation>Die Vorlage bleibt, wo sie ist</translation>
    </message>
    <message>
        <source>&amp;Crop Picture to Shape</source>
        <translation>Vorlage auf die Form Bild auf die Form &amp;zuschneidenamp;zuschneiden</translation>
    </message>
    <message>
        <source>Show only what is inside the shape; blends never carry more than that</source>
        <translation>Nur zeigen, was in der Form liegt; Überblendungen tragen nie mehr mit</translation>
    </message>
    <message>
        <source>R&amp;emove Picture</source>
        <translation>Vorlage e&amp;ntfernen</translation>
    </message>
    <message>
        <source>Take the picture away from behind the shape</source>
        <translation>Die Vorlage hinter der Form wegnehmen</translation>
    </message>
    <message>
        <source>&amp;Add Key Shape</source>
        <translation>Schlüsselform &amp;anfügen</translation>
    </message>
    <message>
        <source>Put an empty shape behind the target, for the blend to go on to</source>
        <translation>Hinter dem Ziel eine leere Form anfügen, zu der der Übergang weitergeht</translation>
    </message>
    <message>
        <source>D&amp;uplicate Key Shape</source>
        <translation>Schlüsselform &amp;duplizieren</translation>
    </message>
    <message>
        <source>Put a copy behind the shape last worked on</source>
        <translation>Hinter der zuletzt bearbeiteten Form eine Kopie einfügen</translation>
    </message>
    <message>
        <source>&amp;Delete Key Shape</source>
        <translation>Schlüsselform &amp;löschen</translation>
    </message>
    <message>
        <source>Take the shape last worked on out of the sequence</source>
        <translation>Die zuletzt bearbeitete Form aus der Folge nehmen</translation>
    </message>
    <message>
        <source>Move &amp;Earlier</source>
        <translation>Nach &amp;vorn rücken</translation>
    </message>
    <message>
        <source>Let the shape last worked on change places with the one before it</source>
        <translation>Die zuletzt bearbeitete Form mit der vorigen vertauschen</translation>
    </message>
    <message>
        <source>Move &amp;Later</source>
        <translation>Nach &amp;hinten rücken</translation>
    </message>
    <message>
        <source>Let the shape last worked on change places with the one behind it</source>
        <translation>Die zuletzt bearbeitete Form mit der folgenden vertauschen</translation>
    </message>
    <message>
        <source>&amp;Previous Step</source>
        <translation>Vo&amp;riger Schritt</translation>
    </message>
    <message>
        <source>Put the pair of shapes before on the canvases</source>
        <translation>Das vorige Paar von Formen auf die Flächen holen</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>Put the next pair of shapes on the canvases</source>
        <translation>Das nächste Paar von Formen auf die Flächen holen</translation>
    </message>
    <message>
        <source>Play &amp;Only This Step</source>
        <translation>Nur diesen &amp;Schritt abspielen</translation>
    </message>
    <message>
        <source>Play only between the two shapes on the canvases, not all shapes</source>
        <translation>Nur zwischen den beiden Formen auf den Flächen abspielen, nicht durch alle Formen</translation>
    </message>
    <message>
        <source>Histor&amp;y</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Show the list of edits, to go back to any of them</source>
        <translation>Die Liste der Änderungen zeigen, um zu jeder zurückzugehen</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Read how it is done: blends, marks, exports, scripts</source>
        <translation>Nachlesen, wie es geht: Überblendungen, Marken, Exporte, Skripte</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>Befehl &amp;finden…</translation>
    </message>
    <message>
        <source>Find a command by a part of its name</source>
        <translation>Einen Befehl an einem Teil seines Namens finden</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>&amp;Tastenkürzel…</translation>
    </message>
    <message>
        <source>See and change the keys of all commands</source>
        <translation>Die Tasten aller Befehle sehen und ändern</translation>
    </message>
    <message>
        <source>&amp;About starskel…</source>
        <translation>&amp;Über starskel…</translation>
    </message>
    <message>
        <source>What the program is, and its versions</source>
        <translation>Was das Programm ist, und seine Versionen</translation>
    </message>
    <message>
        <source>&amp;Add Part</source>
        <translation>Teil &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Draw one more polygon of the shape; inside another one it is a hole</source>
        <translation>Ein weiteres Polygon der Form zeichnen; in einem anderen ist es ein Loch</translation>
    </message>
    <message>
        <source>&amp;Remove Part</source>
        <translation>Teil &amp;entfernen</translation>
    </message>
    <message>
        <source>Take the part worked on away from both shapes</source>
        <translation>Das bearbeitete Teil aus beiden Formen nehmen</translation>
    </message>
    <message>
        <source>Pre&amp;vious Part</source>
        <translation>&amp;Voriges Teil</translation>
    </message>
    <message>
        <source>Work on the part before in the list</source>
        <translation>Das vorige Teil der Liste bearbeiten</translation>
    </message>
    <message>
        <source>Ne&amp;xt Part</source>
        <translation>&amp;Nächstes Teil</translation>
    </message>
    <message>
        <source>Work on the next part of the list</source>
        <translation>Das nächste Teil der Liste bearbeiten</translation>
    </message>
    <message>
        <source>Bring &amp;Forward</source>
        <translation>Nach vo&amp;rn</translation>
    </message>
    <message>
        <source>Paint the part over the next one</source>
        <translation>Das Teil über das nächste malen</translation>
    </message>
    <message>
        <source>Send &amp;Backward</source>
        <translation>Nach h&amp;inten</translation>
    </message>
    <message>
        <source>Paint the part under the one before</source>
        <translation>Das Teil unter das vorige malen</translation>
    </message>
    <message>
        <source>&amp;Show Part</source>
        <translation>Teil an&amp;zeigen</translation>
    </message>
    <message>
        <source>Show the part or hide it, on the canvases and in the frames</source>
        <translation>Das Teil auf den Flächen und in den Bildern zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Colour of Part…</source>
        <translation>&amp;Farbe des Teils…</translation>
    </message>
    <message>
        <source>Choose a colour for the part</source>
        <translation>Eine Farbe für das Teil wählen</translation>
    </message>
    <message>
        <source>&amp;Usual Colour</source>
        <translation>&amp;Übliche Farbe</translation>
    </message>
    <message>
        <source>Give the part the colour that shapes usually have</source>
        <translation>Dem Teil die Farbe geben, die Formen sonst haben</translation>
    </message>
    <message>
        <source>Leave Wit&amp;hout Partner</source>
        <translation>Ohne Partner l&amp;assen</translation>
    </message>
    <message>
        <source>Let the part shrink to a point, and its partner grow from one</source>
        <translation>Das Teil zu einem Punkt schrumpfen und seinen Partner aus einem wachsen lassen</translation>
    </message>
    <message>
        <source>&amp;Place of Growth</source>
        <translation>&amp;Ort des Wachsens</translation>
    </message>
    <message>
        <source>Choose where a part without a partner grows from, or shrinks to</source>
        <translation>Wählen, woraus ein Teil ohne Partner wächst oder wohin es schrumpft</translation>
    </message>
    <message>
        <source>Usual Place of Gro&amp;wth</source>
        <translation>Ü&amp;blicher Ort des Wachsens</translation>
    </message>
    <message>
        <source>Leave it to the program where the part grows from, or shrinks to</source>
        <translation>Dem Programm überlassen, woraus das Teil wächst oder wohin es schrumpft</translation>
    </message>
    <message>
        <source>Suggest Pairin&amp;g</source>
        <translation>&amp;Partner vorschlagen</translation>
    </message>
    <message>
        <source>Let parts become those that fit them best in size and place</source>
        <translation>Teile zu denen werden lassen, die in Größe und Lage am besten passen</translation>
    </message>
    <message>
        <source>Move &amp;Together</source>
        <translation>&amp;Gemeinsam bewegen</translation>
    </message>
    <message>
        <source>Let the parts move together, instead of each by itself</source>
        <translation>Die Teile gemeinsam bewegen statt jedes für sich</translation>
    </message>
    <message>
        <source>Parts &amp;List</source>
        <translation>&amp;Liste der Teile</translation>
    </message>
    <message>
        <source>Show the list of parts and what becomes of them</source>
        <translation>Die Liste der Teile zeigen und was aus ihnen wird</translation>
    </message>
</context>
<context>
    <name>Counts</name>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation>
            <numerusform>%n Eckpunkt</numerusform>
            <numerusform>%n Eckpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks</source>
        <translation>
            <numerusform>%n Marke</numerusform>
            <numerusform>%n Marken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes</source>
        <translation>
            <numerusform>%n Loch</numerusform>
            <numerusform>%n Löcher</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n seconds left</source>
        <translation>
            <numerusform>noch etwa %n Sekunde</numerusform>
            <numerusform>noch etwa %n Sekunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{name} holds %n shapes.</source>
        <translation>
            <numerusform>{name} enthält %n Form.</numerusform>
            <numerusform>{name} enthält %n Formen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices: blending takes minutes and much memory. F5 begins, Esc ends it.</source>
        <translation>
            <numerusform>%n Eckpunkt: Das Überblenden dauert Minuten und braucht viel Speicher. F5 beginnt, Esc beendet es.</numerusform>
            <numerusform>%n Eckpunkte: Das Überblenden dauert Minuten und braucht viel Speicher. F5 beginnt, Esc beendet es.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes are parts now, as they are no longer inside their outline.</source>
        <translation>
            <numerusform>%n Loch ist jetzt ein Teil, denn es liegt nicht mehr in seinem Umriss.</numerusform>
            <numerusform>%n Löcher sind jetzt Teile, denn sie liegen nicht mehr in ihrem Umriss.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts are holes now, as they are inside another part.</source>
        <translation>
            <numerusform>%n Teil ist jetzt ein Loch, denn es liegt in einem anderen Teil.</numerusform>
            <numerusform>%n Teile sind jetzt Löcher, denn sie liegen in einem anderen Teil.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks went with this edit. Undo brings them back.</source>
        <translation>
            <numerusform>%n Marke ging mit dieser Änderung verloren. „Rückgängig“ bringt sie wieder.</numerusform>
            <numerusform>%n Marken gingen mit dieser Änderung verloren. „Rückgängig“ bringt sie wieder.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>All that can be opened ({endings})</source>
        <translation>Alles, was sich öffnen lässt ({endings})</translation>
    </message>
    <message>
        <source>Projects and polygon pairs (*.json)</source>
        <translation>Projekte und Polygonpaare (*.json)</translation>
    </message>
    <message>
        <source>Drawings, maps, pictures and fonts ({endings})</source>
        <translation>Zeichnungen, Karten, Bilder und Schriften ({endings})</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import shapes</source>
        <translation>Formen importieren</translation>
    </message>
    <message>
        <source>Open picture</source>
        <translation>Bildvorlage öffnen</translation>
    </message>
    <message>
        <source>Pictures ({endings});;All files (*)</source>
        <translation>Bilder ({endings});;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “{name}”?</source>
        <translation>Die Änderungen an „{name}“ speichern?</translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation>Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>Von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>{name} was changed by another program since it was opened here.</source>
        <translation>{name} wurde von einem anderen Programm geändert, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Overwriting it loses what that program has written.</source>
        <translation>Beim Überschreiben geht verloren, was jenes Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>Save &amp;Elsewhere…</source>
        <translation>&amp;Anderswo speichern…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>{name} was not saved</source>
        <translation>{name} wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>The document is still open, with all its changes.</source>
        <translation>Das Dokument ist noch offen, mit allen Änderungen.</translation>
    </message>
    <message>
        <source>Overwrite?</source>
        <translation>Überschreiben?</translation>
    </message>
    <message>
        <source>Files of these names are already there.</source>
        <translation>Dateien mit diesen Namen gibt es schon.</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Nicht möglich</translation>
    </message>
</context>
<context>
    <name>Easing</name>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Ease in</source>
        <translation>Sanft beginnen</translation>
    </message>
    <message>
        <source>Ease out</source>
        <translation>Sanft enden</translation>
    </message>
    <message>
        <source>Ease in and out</source>
        <translation>Sanft beginnen und enden</translation>
    </message>
    <message>
        <source>Linger at both ends</source>
        <translation>An beiden Enden verweilen</translation>
    </message>
    <message>
        <source>Linger half-way</source>
        <translation>Auf halbem Weg verweilen</translation>
    </message>
</context>
<context>
    <name>EasingButton</name>
    <message>
        <source>Easing</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>Easing: how t runs over the time</source>
        <translation>Zeitverlauf: wie t mit der Zeit läuft</translation>
    </message>
</context>
<context>
    <name>EasingCurve</name>
    <message>
        <source>Easing curve</source>
        <translation>Kurve des Zeitverlaufs</translation>
    </message>
    <message>
        <source>Drag a handle; arrow keys move it, Space takes the other one</source>
        <translation>Griff ziehen; Pfeiltasten bewegen ihn, die Leertaste nimmt den anderen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>EasingPopup</name>
    <message>
        <source>Easing</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Wie gezeichnet</translation>
    </message>
    <message>
        <source>For all steps</source>
        <translation>Für alle Schritte</translation>
    </message>
    <message>
        <source>Let t run over all steps as over this one</source>
        <translation>t über alle Schritte so laufen lassen wie über diesen</translation>
    </message>
</context>
<context>
    <name>Example</name>
    <message>
        <source>An arm bends</source>
        <translation>Ein Arm beugt sich</translation>
    </message>
    <message>
        <source>A comb bends</source>
        <translation>Ein Kamm biegt sich</translation>
    </message>
    <message>
        <source>Figure 1: a gecko walks</source>
        <translation>Abbildung 1: ein Gecko läuft</translation>
    </message>
    <message>
        <source>Both poses fall into the same star pieces, and a skeleton joins these; the pieces carry the gecko from pose to pose.</source>
        <translation>Beide Haltungen zerfallen in dieselben Stern-Stücke, die ein Skelett verbindet; die Stücke tragen den Gecko von einer Haltung zur anderen.</translation>
    </message>
    <message>
        <source>Figure 10: dog and cat</source>
        <translation>Abbildung 10: Hund und Katze</translation>
    </message>
    <message>
        <source>A picture in each shape, carried along by the star pieces. One fades into the other while both turn and stretch with their outlines. The pictures are of Fluent Emoji (Microsoft, MIT licence).</source>
        <translation>Ein Bild in jeder Form, von den Stern-Stücken mitgenommen: Eines geht ins andere über, während sich beide mit ihren Umrissen drehen und strecken. Die Bilder stammen aus Fluent Emoji (Microsoft, MIT-Lizenz).</translation>
    </message>
    <message>
        <source>Figure 11: a snake coils</source>
        <translation>Abbildung 11: eine Schlange rollt sich ein</translation>
    </message>
    <message>
        <source>The head was outside the coil and comes inside: somewhere it must pass over the tail, as a snake in the world would.</source>
        <translation>Der Kopf lag außerhalb der Windung und kommt hinein: irgendwo muss er über den Schwanz hinweg, wie bei einer wirklichen Schlange.</translation>
    </message>
    <message>
        <source>Figure 2: a snake turns</source>
        <translation>Abbildung 2: eine Schlange wendet</translation>
    </message>
    <message>
        <source>Vertex interpolation shrinks the body to a quarter and runs it through itself; the star-skeleton bends it.</source>
        <translation>Die Methode „Eckpunkte“ lässt den Körper auf ein Viertel schrumpfen und durch sich selbst laufen; das Stern-Skelett biegt ihn.</translation>
    </message>
    <message>
        <source>Figure 3: a swan dips</source>
        <translation>Abbildung 3: ein Schwan taucht ein</translation>
    </message>
    <message>
        <source>Edge-angle interpolation blows the body up by a fifth on the way; the star-skeleton, which knows the inside, by half as much.</source>
        <translation>Die Methode „Kanten und Winkel“ bläht den Körper unterwegs um ein Fünftel auf; das Stern-Skelett, das das Innere kennt, um halb so viel.</translation>
    </message>
    <message>
        <source>Figure 4: an octopus</source>
        <translation>Abbildung 4: ein Krake</translation>
    </message>
    <message>
        <source>Six arms bend and stretch at once: edge-angle interpolation distorts the area, the star-skeleton keeps it within some hundredths.</source>
        <translation>Sechs Arme biegen und strecken sich zugleich: „Kanten und Winkel“ verzerrt die Fläche, das Stern-Skelett hält sie auf wenige Hundertstel.</translation>
    </message>
    <message>
        <source>Figure 5: an elephant</source>
        <translation>Abbildung 5: ein Elefant</translation>
    </message>
    <message>
        <source>Edge-angle interpolation pushes edges through each other where the trunk bends; the star-skeleton does not.</source>
        <translation>Die Methode „Kanten und Winkel“ schiebt Kanten durcheinander, wo sich der Rüssel biegt; das Stern-Skelett nicht.</translation>
    </message>
    <message>
        <source>Figure 6: an eel curls</source>
        <translation>Abbildung 6: ein Aal krümmt sich</translation>
    </message>
    <message>
        <source>Edge-angle interpolation runs the tail through itself; the star-skeleton keeps both sides of it apart.</source>
        <translation>Die Methode „Kanten und Winkel“ lässt den Schwanz durch sich selbst laufen; das Stern-Skelett hält seine beiden Seiten auseinander.</translation>
    </message>
    <message>
        <source>Figure 8: two zigzags</source>
        <translation>Abbildung 8: zwei Zickzacke</translation>
    </message>
    <message>
        <source>No diagonals of the one are diagonals of the other, so only added Steiner vertices cut both into the same star pieces.</source>
        <translation>Keine Diagonale des einen ist eine des anderen; nur zusätzliche Steiner-Punkte zerlegen beide in dieselben Stern-Stücke.</translation>
    </message>
    <message>
        <source>Figure 9: a fish turns</source>
        <translation>Abbildung 9: ein Fisch wendet</translation>
    </message>
    <message>
        <source>The fish turns round in six parts. Joined by the meta-skeleton they swim on in line; interpolated separately, each moves straight to its place, and all run into each other.</source>
        <translation>Der Fisch wendet in sechs Teilen. Vom Meta-Skelett verbunden schwimmen sie in einer Reihe; einzeln interpoliert geht jeder geradewegs an seinen Platz, und alle laufen ineinander.</translation>
    </message>
    <message>
        <source>Arms swing</source>
        <translation>Arme schwingen</translation>
    </message>
    <message>
        <source>A hand opens</source>
        <translation>Eine Hand öffnet sich</translation>
    </message>
    <message>
        <source>A becomes R</source>
        <translation>A wird R</translation>
    </message>
    <message>
        <source>The hole of the A becomes that of the R; bridges to it are found that fit both letters.</source>
        <translation>Das Loch des A wird das des R; zu ihm finden sich Brücken, die in beide Buchstaben passen.</translation>
    </message>
    <message>
        <source>B becomes 8</source>
        <translation>B wird 8</translation>
    </message>
    <message>
        <source>Two holes each, each paired with the one at its place.</source>
        <translation>Je zwei Löcher, jedes gehört zu dem an seiner Stelle.</translation>
    </message>
    <message>
        <source>i becomes j</source>
        <translation>i wird j</translation>
    </message>
    <message>
        <source>Two parts, the dot and the stem, which move together.</source>
        <translation>Zwei Teile, der Punkt und der Stamm, die sich zusammen bewegen.</translation>
    </message>
    <message>
        <source>O becomes Q</source>
        <translation>O wird Q</translation>
    </message>
    <message>
        <source>One hole, and a tail that grows out of the outline.</source>
        <translation>Ein Loch, und ein Schweif, der aus dem Umriss wächst.</translation>
    </message>
    <message>
        <source>C becomes S</source>
        <translation>C wird S</translation>
    </message>
    <message>
        <source>U becomes S</source>
        <translation>U wird S</translation>
    </message>
    <message>
        <source>Five points become eight</source>
        <translation>Fünf Spitzen werden acht</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Keyframes in a row</source>
        <translation>Schlüsselbilder in einer Reihe</translation>
    </message>
    <message>
        <source>One frame</source>
        <translation>Ein Zwischenbild</translation>
    </message>
    <message>
        <source>All methods side by side</source>
        <translation>Alle Methoden nebeneinander</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Pictures alone</source>
        <translation>Die Bilder allein</translation>
    </message>
    <message>
        <source>Coordinates of keyframes</source>
        <translation>Koordinaten der Schlüsselbilder</translation>
    </message>
    <message>
        <source>Export keyframes</source>
        <translation>Schlüsselbilder exportieren</translation>
    </message>
    <message>
        <source>The whole sequence</source>
        <translation>Die ganze Folge</translation>
    </message>
    <message>
        <source>From the first key shape to the last, once all steps are blended</source>
        <translation>Von der ersten Schlüsselform bis zur letzten, sobald alle Schritte überblendet sind</translation>
    </message>
    <message>
        <source>Apart as played, with easing</source>
        <translation>Abstände wie abgespielt, mit Zeitverlauf</translation>
    </message>
    <message>
        <source>Pi&amp;xels</source>
        <translation>Pi&amp;xel</translation>
    </message>
    <message>
        <source>Each keyframe by itself</source>
        <translation>Jedes Schlüsselbild für sich</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>The longer side, of formats that are made of pixels</source>
        <translation>Die längere Seite, bei Formaten aus Pixeln</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Was</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Methode</translation>
    </message>
    <message>
        <source>&amp;Keyframes</source>
        <translation>&amp;Schlüsselbilder</translation>
    </message>
    <message>
        <source>At t&amp;hese times</source>
        <translation>Zu d&amp;iesen Zeiten</translation>
    </message>
    <message>
        <source>&amp;Time t</source>
        <translation>&amp;Zeit t</translation>
    </message>
    <message>
        <source>Times are numbers from 0 to 1, set apart by spaces</source>
        <translation>Zeiten sind Zahlen von 0 bis 1, durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>Can be written as {names}</source>
        <translation>Geschrieben als {names}</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
</context>
<context>
    <name>FaultDialog</name>
    <message>
        <source>A fault in the program</source>
        <translation>Ein Fehler im Programm</translation>
    </message>
    <message>
        <source>Your document is still here, and what was not saved has been kept in case it ends.</source>
        <translation>Ihr Dokument ist noch da, und was nicht gespeichert war, ist aufbewahrt, falls das Programm endet.</translation>
    </message>
    <message>
        <source>Your document is still here, but it could not be kept: save it under another name.</source>
        <translation>Ihr Dokument ist noch da, konnte aber nicht gesichert werden: Speichern Sie es unter anderem Namen.</translation>
    </message>
    <message>
        <source>Something went wrong inside the program.</source>
        <translation>Im Programm ist etwas schiefgegangen.</translation>
    </message>
    <message>
        <source>With this report the fault can be found and mended:</source>
        <translation>Mit diesem Bericht lässt sich der Fehler finden und beheben:</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>&amp;Copy Report</source>
        <translation>Bericht &amp;kopieren</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>{name} cannot be opened</source>
        <translation>{name} lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Saving {name}…</source>
        <translation>{name} wird gespeichert …</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Writing {name}…</source>
        <translation>{name} wird geschrieben …</translation>
    </message>
    <message>
        <source>{name} was not written</source>
        <translation>{name} wurde nicht geschrieben</translation>
    </message>
</context>
<context>
    <name>Finder</name>
    <message>
        <source>Find command</source>
        <translation>Befehl finden</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Part of a command&apos;s name</source>
        <translation>Teil eines Befehlsnamens</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>Adjust the last step in the options above, or go on.</source>
        <translation>Den letzten Schritt oben in den Optionen anpassen oder weiterarbeiten.</translation>
    </message>
    <message>
        <source>Click to set the first vertex. The new shape takes the place of the one that is worked on.</source>
        <translation>Klicken setzt den ersten Eckpunkt. Die neue Form tritt an die Stelle der bearbeiteten.</translation>
    </message>
    <message>
        <source>Click adds a vertex; the first vertex or Enter closes. Backspace takes one back, Esc cancels.</source>
        <translation>Klick setzt einen Eckpunkt; der erste Eckpunkt oder Enter schließt. Rücktaste nimmt einen zurück, Esc bricht ab.</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift makes a square; Ctrl suspends snapping.</source>
        <translation>Von Ecke zu Ecke ziehen. Umschalt macht ein Quadrat; Strg setzt das Einrasten aus.</translation>
    </message>
    <message>
        <source>Drag from corner to corner of its box. Shift makes a circle; Ctrl suspends snapping.</source>
        <translation>Ihren Rahmen von Ecke zu Ecke ziehen. Umschalt macht einen Kreis; Strg setzt das Einrasten aus.</translation>
    </message>
    <message>
        <source>Drag from the middle to a corner. Shift turns by steps of 15°; Ctrl suspends snapping.</source>
        <translation>Von der Mitte zu einer Ecke ziehen. Umschalt dreht in Schritten von 15°; Strg setzt das Einrasten aus.</translation>
    </message>
    <message>
        <source>Drag from the middle to a point. Shift turns by steps of 15°; Ctrl suspends snapping.</source>
        <translation>Von der Mitte zu einer Spitze ziehen. Umschalt dreht in Schritten von 15°; Strg setzt das Einrasten aus.</translation>
    </message>
    <message>
        <source>Release to draw the figure; Esc gives it up.</source>
        <translation>Loslassen zeichnet die Figur; Esc gibt sie auf.</translation>
    </message>
    <message>
        <source>Press and draw the outline in one go; it closes itself. How closely it is followed is set above.</source>
        <translation>Drücken und den Umriss in einem Zug zeichnen; er schließt sich selbst. Wie genau ihm gefolgt wird, ist oben einstellbar.</translation>
    </message>
    <message>
        <source>Release to close the outline; Esc gives it up.</source>
        <translation>Loslassen schließt den Umriss; Esc gibt ihn auf.</translation>
    </message>
    <message>
        <source>Click a vertex, then its partner on the other canvas, or drag from one to the other. Click a pin to remove it, drag it to move it.</source>
        <translation>Einen Eckpunkt anklicken, dann seinen Partner auf der anderen Fläche, oder vom einen zum anderen ziehen. Klick auf eine Marke entfernt sie, Ziehen versetzt sie.</translation>
    </message>
    <message>
        <source>Click the vertex that corresponds on the other canvas, or drag there; Esc cancels.</source>
        <translation>Den entsprechenden Eckpunkt auf der anderen Fläche anklicken oder dorthin ziehen; Esc bricht ab.</translation>
    </message>
    <message>
        <source>Release on another vertex to move the pin there; Esc puts it back.</source>
        <translation>Auf einem anderen Eckpunkt loslassen, um die Marke dorthin zu setzen; Esc stellt sie zurück.</translation>
    </message>
    <message>
        <source>Release to set the vertices here; Esc puts them back. Ctrl suspends snapping.</source>
        <translation>Loslassen setzt die Eckpunkte hierher; Esc stellt sie zurück. Strg setzt das Einrasten aus.</translation>
    </message>
    <message>
        <source>Release to keep it so; Esc puts it back. Shift keeps the proportions, or steps of 15°.</source>
        <translation>Loslassen behält es so; Esc stellt es zurück. Umschalt hält die Proportionen oder Schritte von 15°.</translation>
    </message>
    <message>
        <source>Drag vertices or edges, click the shape to select it whole, double-click an edge to insert. Shift adds; arrow keys move, with Alt they turn and scale.</source>
        <translation>Eckpunkte oder Kanten ziehen, Klick auf die Form wählt sie ganz, Doppelklick auf eine Kante fügt ein. Umschalt ergänzt; Pfeiltasten bewegen, mit Alt drehen und skalieren sie.</translation>
    </message>
    <message>
        <source>Release to select the vertices in the box.</source>
        <translation>Loslassen wählt die Eckpunkte im Rahmen aus.</translation>
    </message>
    <message>
        <source>Click where the part without a partner grows from or shrinks to, on the canvas without it.</source>
        <translation>Auf der Fläche ohne das Teil dorthin klicken, woraus es wächst oder wohin es schrumpft.</translation>
    </message>
    <message>
        <source>Type the text above, then click to set it in the place of the shape on the canvas.</source>
        <translation>Den Text oben tippen, dann klicken: Er tritt an die Stelle der Form auf der Fläche.</translation>
    </message>
    <message>
        <source>Drag the picture, its corners or sides to fit it, or the round handle to turn it. Arrow keys move it, with Alt they turn and scale.</source>
        <translation>Vorlage, Ecken oder Seiten ziehen, um es einzupassen, am runden Griff drehen. Pfeiltasten verschieben, mit Alt drehen und skalieren sie.</translation>
    </message>
    <message>
        <source>Release to leave the picture here; Esc puts it back. Shift frees the proportions, or steps by 15°.</source>
        <translation>Loslassen lässt die Vorlage hier; Esc setzt sie zurück. Umschalt gibt die Proportionen frei oder dreht in Schritten von 15°.</translation>
    </message>
</context>
<context>
    <name>HistoryList</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
</context>
<context>
    <name>Importing</name>
    <message>
        <source>{name} cannot be read</source>
        <translation>{name} lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>Mended: {what}</source>
        <translation>Ausgebessert: {what}</translation>
    </message>
</context>
<context>
    <name>KeyStrip</name>
    <message>
        <source>Key shapes, {step} on the canvases</source>
        <translation>Schlüsselformen, auf den Flächen {step}</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Shape {letter}, {size}. Drag it to move it to another place.</source>
        <translation>Form {letter}, {size}. Ziehen bringt sie an einen anderen Platz.</translation>
    </message>
    <message>
        <source>{letters}, {marks}. Click to show them on the canvases.</source>
        <translation>{letters}, {marks}. Ein Klick zeigt sie auf den Flächen.</translation>
    </message>
    <message>
        <source>Add a shape</source>
        <translation>Eine Form anfügen</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Area drift</source>
        <translation>Flächenabweichung</translation>
    </message>
    <message>
        <source>Length drift</source>
        <translation>Längenabweichung</translation>
    </message>
</context>
<context>
    <name>LookFields</name>
    <message>
        <source>Usual colours</source>
        <translation>Übliche Farben</translation>
    </message>
    <message>
        <source>Own colours</source>
        <translation>Eigene Farben</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Colour of the source</source>
        <translation>Farbe der Quelle</translation>
    </message>
    <message>
        <source>Colour of the target</source>
        <translation>Farbe des Ziels</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Colour of the outline</source>
        <translation>Farbe des Umrisses</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Else nothing is behind; sheets and video are white</source>
        <translation>Sonst ist nichts dahinter; Übersichten und Videos sind weiß</translation>
    </message>
    <message>
        <source>Colour of the paper</source>
        <translation>Farbe des Papiers</translation>
    </message>
    <message>
        <source>Of frames in a row, in a sheet, or side by side</source>
        <translation>Bei Bildern in einer Reihe, auf einem Blatt oder nebeneinander</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>The longer side of the largest frame</source>
        <translation>Die längere Seite des größten Bildes</translation>
    </message>
    <message>
        <source>Times below</source>
        <translation>Zeiten darunter</translation>
    </message>
    <message>
        <source>Signs where frames cross themselves</source>
        <translation>Zeichen, wo Bilder sich selbst schneiden</translation>
    </message>
    <message>
        <source>Width of the outline</source>
        <translation>Breite des Umrisses</translation>
    </message>
    <message>
        <source>F&amp;illed with</source>
        <translation>Gef&amp;üllt mit</translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>&amp;Between frames</source>
        <translation>Zwischen &amp;Bildern</translation>
    </message>
    <message>
        <source>Largest &amp;frame</source>
        <translation>&amp;Größtes Bild</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>The language changes with the next start.</source>
        <translation>Die Sprache wechselt mit dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>{command} {step}</source>
        <translation>{command}: {step}</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Nicht gefunden</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Vorwärts</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Inhalt</translation>
    </message>
</context>
<context>
    <name>MarksModel</name>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Type the numbers of two vertices that correspond</source>
        <translation>Die Nummern zweier Eckpunkte eingeben, die einander entsprechen</translation>
    </message>
</context>
<context>
    <name>MarksPanel</name>
    <message>
        <source>How many marks</source>
        <translation>Wie viele Marken</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>Replace all marks by ones that suggest themselves</source>
        <translation>Alle Marken durch vorgeschlagene ersetzen</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Type a vertex number to change it, Del removes. New marks go in the last row.</source>
        <translation>Eine Eckpunktnummer eintippen ändert sie, Entf löscht. Neue Marken kommen in die letzte Zeile.</translation>
    </message>
</context>
<context>
    <name>MarksTable</name>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Drawing Tools</source>
        <translation>Zeichenwerkzeuge</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>&amp;Beispiele</translation>
    </message>
    <message>
        <source>Figures of the paper</source>
        <translation>Abbildungen des Aufsatzes</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Methods</source>
        <translation>&amp;Methoden</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>vertex</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>edge-angle</source>
        <translation>Kanten und Winkel</translation>
    </message>
    <message>
        <source>star-skeleton</source>
        <translation>Stern-Skelett</translation>
    </message>
    <message>
        <source>stitched</source>
        <translation>vernäht</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>certified</source>
        <translation>zertifiziert</translation>
    </message>
</context>
<context>
    <name>MethodTip</name>
    <message>
        <source>Turns and stretches all pieces evenly; seldom crosses itself.</source>
        <translation>Dreht und dehnt alle Stücke gleichmäßig, schneidet sich selten.</translation>
    </message>
    <message>
        <source>Proven not to cross itself at any t; takes longer.</source>
        <translation>Bewiesen ohne Selbstschnitt für jedes t, dauert länger.</translation>
    </message>
    <message>
        <source>Keeps the inside as rigid as possible, triangle by triangle.</source>
        <translation>Hält das Innere so starr wie möglich, Dreieck für Dreieck.</translation>
    </message>
    <message>
        <source>Unfolds star-shaped pieces along a skeleton that bends.</source>
        <translation>Entfaltet sternförmige Stücke entlang eines Skeletts, das sich biegt.</translation>
    </message>
    <message>
        <source>Changes lengths of edges and the angles between them evenly.</source>
        <translation>Ändert Längen von Kanten und die Winkel dazwischen gleichmäßig.</translation>
    </message>
    <message>
        <source>Moves every vertex on a straight line.</source>
        <translation>Bewegt jeden Eckpunkt auf einer geraden Linie.</translation>
    </message>
</context>
<context>
    <name>MotionFields</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Of formats that are made of pictures</source>
        <translation>Bei Formaten aus Einzelbildern</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How far vertices may stray between keys of SVG and Lottie, of the box of all frames</source>
        <translation>Wie weit Eckpunkte zwischen Schlüsseln von SVG und Lottie abweichen dürfen, vom Rechteck um alle Bilder</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Dauer</translation>
    </message>
    <message>
        <source>Pictures a &amp;second</source>
        <translation>Bilder &amp;je Sekunde</translation>
    </message>
    <message>
        <source>T&amp;olerance</source>
        <translation>T&amp;oleranz</translation>
    </message>
</context>
<context>
    <name>OptionsBar</name>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Vertices to add</source>
        <translation>Neue Eckpunkte</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Innenradius</translation>
    </message>
    <message>
        <source>Snap to</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation>Abstand im Gitter</translation>
    </message>
</context>
<context>
    <name>OverlayFields</name>
    <message>
        <source>Pictures in the shapes</source>
        <translation>Bilder in den Formen</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Star pieces</source>
        <translation>Stern-Stücke</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Skelett</translation>
    </message>
</context>
<context>
    <name>PairDialog</name>
    <message>
        <source>Choose a pair</source>
        <translation>Ein Paar wählen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>The file holds {count} pairs of shapes.</source>
        <translation>Die Datei enthält {count} Paare von Formen.</translation>
    </message>
</context>
<context>
    <name>Panel</name>
    <message>
        <source>Verdict on {method}</source>
        <translation>Urteil über: {method}</translation>
    </message>
    <message>
        <source>no blend</source>
        <translation>kein Übergang</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>wird berechnet…</translation>
    </message>
    <message>
        <source>{verdict} (out of date)</source>
        <translation>{verdict} (veraltet)</translation>
    </message>
    <message>
        <source>The in-between shapes appear here as soon as there are a source and a target.</source>
        <translation>Hier erscheinen die Zwischenformen, sobald es eine Quelle und ein Ziel gibt.</translation>
    </message>
    <message>
        <source>Cancelled. F5 computes it again.</source>
        <translation>Abgebrochen. F5 berechnet es neu.</translation>
    </message>
</context>
<context>
    <name>Part</name>
    <message>
        <source>Part {number}</source>
        <translation>Teil {number}</translation>
    </message>
    <message>
        <source>New part {number}</source>
        <translation>Neues Teil {number}</translation>
    </message>
    <message>
        <source>{part} to {number}</source>
        <translation>{part} zu {number}</translation>
    </message>
    <message>
        <source>from a point</source>
        <translation>aus einem Punkt</translation>
    </message>
    <message>
        <source>to a point</source>
        <translation>zu einem Punkt</translation>
    </message>
    <message>
        <source>grows from here</source>
        <translation>wächst von hier</translation>
    </message>
    <message>
        <source>shrinks to here</source>
        <translation>schrumpft hierher</translation>
    </message>
</context>
<context>
    <name>Partnering</name>
    <message>
        <source>Colour of the part</source>
        <translation>Farbe des Teils</translation>
    </message>
</context>
<context>
    <name>PartsModel</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Tick to show it, double-click to rename it, drag to change what is painted first</source>
        <translation>Anhaken zeigt es, Doppelklick benennt es um, Ziehen ändert die Reihenfolge des Malens</translation>
    </message>
    <message>
        <source>This part has no partner: drag one here</source>
        <translation>Dieses Teil hat keinen Partner: einen hierher ziehen</translation>
    </message>
    <message>
        <source>Drag it onto another row to pair it there; with Control pressed it is paired besides</source>
        <translation>Auf eine andere Zeile ziehen, um es dort zu paaren; mit Strg kommt es zu dem Partner dort hinzu</translation>
    </message>
</context>
<context>
    <name>PartsPanel</name>
    <message>
        <source>Drag a source or a target onto another row to pair it there; Enter lets you choose a partner.</source>
        <translation>Quelle oder Ziel auf eine andere Zeile ziehen, um sie dort zu paaren; Enter lässt einen Partner wählen.</translation>
    </message>
</context>
<context>
    <name>PartsTable</name>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
</context>
<context>
    <name>PicturePage</name>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How far the picture is turned, counter-clockwise from upright</source>
        <translation>Wie weit die Vorlage gedreht ist, gegen den Uhrzeigersinn von aufrecht an</translation>
    </message>
</context>
<context>
    <name>PlacementPage</name>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Middle, from left to right</source>
        <translation>Mitte, von links nach rechts</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Middle, upwards</source>
        <translation>Mitte, nach oben</translation>
    </message>
    <message>
        <source>W</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
</context>
<context>
    <name>Recovering</name>
    <message>
        <source>There are no recovered documents.</source>
        <translation>Es gibt keine geretteten Dokumente.</translation>
    </message>
    <message>
        <source>Looking for unsaved documents…</source>
        <translation>Nicht gespeicherte Dokumente werden gesucht …</translation>
    </message>
    <message>
        <source>{name} cannot be opened</source>
        <translation>{name} lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Unsaved changes are kept safe again.</source>
        <translation>Ungespeicherte Änderungen werden wieder gesichert.</translation>
    </message>
    <message>
        <source>Unsaved changes are not kept safe, so save often: {why}</source>
        <translation>Ungespeicherte Änderungen werden nicht gesichert, speichern Sie also oft: {why}</translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>Recovered documents</source>
        <translation>Gerettete Dokumente</translation>
    </message>
    <message>
        <source>The program ended unexpectedly. What was not saved then has been kept:</source>
        <translation>Das Programm endete unerwartet. Was da nicht gespeichert war, ist aufbewahrt:</translation>
    </message>
    <message>
        <source>What is left for later is offered again, and is in the File menu.</source>
        <translation>Was für später bleibt, wird wieder angeboten und steht im Menü Datei.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>&amp;Verwerfen…</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Of a newer version of starskel, which can open it</source>
        <translation>Von einer neueren Version von starskel, die es öffnen kann</translation>
    </message>
    <message>
        <source>Damaged, it cannot be opened</source>
        <translation>Beschädigt, es lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>never saved to a file</source>
        <translation>noch nie in einer Datei gespeichert</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Discard the unsaved work on “{name}”?</source>
        <translation>Die ungespeicherte Arbeit an „{name}“ verwerfen?</translation>
    </message>
    <message>
        <source>Discard what cannot be opened here?</source>
        <translation>Verwerfen, was sich hier nicht öffnen lässt?</translation>
    </message>
    <message>
        <source>It cannot be brought back. A saved file stays as it is.</source>
        <translation>Sie lässt sich nicht zurückholen. Eine gespeicherte Datei bleibt, wie sie ist.</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>The red edges would cross or touch. Nothing was changed.</source>
        <translation>Die roten Kanten würden sich kreuzen oder berühren. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Two vertices would be at the same place. Nothing was changed.</source>
        <translation>Zwei Eckpunkte lägen auf derselben Stelle. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>A fault in the program, not in your shapes: {kind}: {error}</source>
        <translation>Ein Fehler im Programm, nicht in Ihren Formen: {kind}: {error}</translation>
    </message>
    <message>
        <source>This vertex already has {first}. Remove that pin first, or take another vertex.</source>
        <translation>Dieser Eckpunkt hat schon {first}. Entfernen Sie sie zuerst, oder nehmen Sie einen anderen Eckpunkt.</translation>
    </message>
    <message>
        <source>{second} would cross {first}: going round, they come in different orders on the two shapes.</source>
        <translation>{second} würde {first} kreuzen: umlaufend folgen sie auf den beiden Formen in verschiedener Reihenfolge.</translation>
    </message>
    <message>
        <source>{{second}} would cross {{first}}: going round from {third}, one of them comes first on the source, the other on the target.</source>
        <translation>{{second}} würde {{first}} kreuzen: umlaufend ab {third} kommt die eine auf der Quelle zuerst, die andere auf dem Ziel.</translation>
    </message>
    <message>
        <source>mark {label}</source>
        <translation>Marke {label}</translation>
    </message>
    <message>
        <source>mark {label}, moved there,</source>
        <translation>Marke {label}, dorthin verschoben,</translation>
    </message>
    <message>
        <source>the new mark {label}</source>
        <translation>die neue Marke {label}</translation>
    </message>
</context>
<context>
    <name>SelectionPage</name>
    <message>
        <source>By how much to turn the selection about its middle</source>
        <translation>Um wie viel die Auswahl um ihre Mitte gedreht wird</translation>
    </message>
</context>
<context>
    <name>SequenceBar</name>
    <message>
        <source>Duration of the step</source>
        <translation>Dauer des Schritts</translation>
    </message>
    <message>
        <source>How long the step on the canvases takes, at speed 1</source>
        <translation>Wie lange der Schritt auf den Flächen dauert, bei Tempo 1</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
</context>
<context>
    <name>ShapeChooser</name>
    <message>
        <source>Leave as it is</source>
        <translation>So lassen, wie sie ist</translation>
    </message>
    <message>
        <source>Choose shapes</source>
        <translation>Formen auswählen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Word for: {side}</source>
        <translation>Wort für: {side}</translation>
    </message>
    <message>
        <source>Mended: {what}</source>
        <translation>Ausgebessert: {what}</translation>
    </message>
</context>
<context>
    <name>ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Kürzel</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Neues Kürzel</translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Zuweisen</translation>
    </message>
    <message>
        <source>&amp;New shortcut:</source>
        <translation>&amp;Neues Kürzel:</translation>
    </message>
    <message>
        <source>&amp;Usual Shortcuts</source>
        <translation>Ü&amp;bliche Kürzel</translation>
    </message>
    <message>
        <source>“{command}” has this shortcut now; assigned here, it loses it.</source>
        <translation>Dieses Kürzel hat jetzt „{command}“ und verliert es, wenn es hier zugewiesen wird.</translation>
    </message>
</context>
<context>
    <name>Side</name>
    <message>
        <source>{letter} (source)</source>
        <translation>{letter} (Quelle)</translation>
    </message>
    <message>
        <source>{letter} (target)</source>
        <translation>{letter} (Ziel)</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>What is being computed</source>
        <translation>Was berechnet wird</translation>
    </message>
    <message>
        <source>What is being read</source>
        <translation>Was gerade gelesen wird</translation>
    </message>
    <message>
        <source>Exported to {path}</source>
        <translation>Exportiert nach {path}</translation>
    </message>
    <message>
        <source>The computation ended by a fault and was begun anew.</source>
        <translation>Die Berechnung endete durch einen Fehler und wurde neu begonnen.</translation>
    </message>
    <message>
        <source>Computing {method}…</source>
        <translation>Berechne: {method}…</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Berechne…</translation>
    </message>
    <message>
        <source>Reading {name}…</source>
        <translation>{name} wird gelesen …</translation>
    </message>
    <message>
        <source>Cancelled; F5 computes again</source>
        <translation>Abgebrochen; F5 berechnet neu</translation>
    </message>
</context>
<context>
    <name>Steering</name>
    <message>
        <source>Whole turns</source>
        <translation>Ganze Drehungen</translation>
    </message>
    <message>
        <source>Whole turns of the star-skeleton on its way, counter-clockwise</source>
        <translation>Ganze Drehungen des Stern-Skeletts auf seinem Weg, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>Drehungen</translation>
    </message>
    <message>
        <source>Usual root</source>
        <translation>Übliche Wurzel</translation>
    </message>
    <message>
        <source>Let the method choose the root again</source>
        <translation>Die Methode die Wurzel wieder selbst wählen lassen</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Choose methods</source>
        <translation>Methoden wählen</translation>
    </message>
    <message>
        <source>Draw freehand</source>
        <translation>Freihand zeichnen</translation>
    </message>
    <message>
        <source>Draw shape</source>
        <translation>Form zeichnen</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>Rechteck zeichnen</translation>
    </message>
    <message>
        <source>Draw ellipse</source>
        <translation>Ellipse zeichnen</translation>
    </message>
    <message>
        <source>Draw regular polygon</source>
        <translation>Vieleck zeichnen</translation>
    </message>
    <message>
        <source>Draw star</source>
        <translation>Stern zeichnen</translation>
    </message>
    <message>
        <source>Set mark</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation>Marke versetzen</translation>
    </message>
    <message>
        <source>Suggest marks</source>
        <translation>Marken vorschlagen</translation>
    </message>
    <message>
        <source>Move vertices</source>
        <translation>Eckpunkte verschieben</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Paste shape</source>
        <translation>Form einfügen</translation>
    </message>
    <message>
        <source>Cut shape</source>
        <translation>Form ausschneiden</translation>
    </message>
    <message>
        <source>Insert vertex</source>
        <translation>Eckpunkt einfügen</translation>
    </message>
    <message>
        <source>Nudge vertices</source>
        <translation>Eckpunkte rücken</translation>
    </message>
    <message>
        <source>Delete parts</source>
        <translation>Teile löschen</translation>
    </message>
    <message>
        <source>Delete vertices</source>
        <translation>Eckpunkte löschen</translation>
    </message>
    <message>
        <source>Set text</source>
        <translation>Text setzen</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Set first vertex</source>
        <translation>Ersten Eckpunkt festlegen</translation>
    </message>
    <message>
        <source>Copy to other canvas</source>
        <translation>Auf die andere Fläche kopieren</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Move picture</source>
        <translation>Vorlage verschieben</translation>
    </message>
    <message>
        <source>Scale picture</source>
        <translation>Vorlage skalieren</translation>
    </message>
    <message>
        <source>Turn picture</source>
        <translation>Vorlage drehen</translation>
    </message>
    <message>
        <source>Place picture</source>
        <translation>Vorlage hinterlegen</translation>
    </message>
    <message>
        <source>Remove picture</source>
        <translation>Vorlage entfernen</translation>
    </message>
    <message>
        <source>Picture opacity</source>
        <translation>Deckkraft der Vorlage</translation>
    </message>
    <message>
        <source>Lock picture</source>
        <translation>Vorlage sperren</translation>
    </message>
    <message>
        <source>Crop picture</source>
        <translation>Vorlage zuschneiden</translation>
    </message>
    <message>
        <source>Trace outline</source>
        <translation>Umriss nachzeichnen</translation>
    </message>
    <message>
        <source>Add key shape</source>
        <translation>Schlüsselform anfügen</translation>
    </message>
    <message>
        <source>Move key shape</source>
        <translation>Schlüsselform verschieben</translation>
    </message>
    <message>
        <source>Set duration</source>
        <translation>Dauer festlegen</translation>
    </message>
    <message>
        <source>Duplicate key shape</source>
        <translation>Schlüsselform duplizieren</translation>
    </message>
    <message>
        <source>Delete key shape</source>
        <translation>Schlüsselform löschen</translation>
    </message>
    <message>
        <source>Set easing</source>
        <translation>Zeitverlauf setzen</translation>
    </message>
    <message>
        <source>Choose root</source>
        <translation>Wurzel wählen</translation>
    </message>
    <message>
        <source>Set whole turns</source>
        <translation>Ganze Drehungen setzen</translation>
    </message>
    <message>
        <source>Take the usual root</source>
        <translation>Übliche Wurzel nehmen</translation>
    </message>
    <message>
        <source>Set place of growth</source>
        <translation>Ort des Wachsens setzen</translation>
    </message>
    <message>
        <source>Rename part</source>
        <translation>Teil umbenennen</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Teil zeigen</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Teil verbergen</translation>
    </message>
    <message>
        <source>Split part</source>
        <translation>Teil aufteilen</translation>
    </message>
    <message>
        <source>Pair parts</source>
        <translation>Teile paaren</translation>
    </message>
    <message>
        <source>Leave without partner</source>
        <translation>Ohne Partner lassen</translation>
    </message>
    <message>
        <source>Reorder parts</source>
        <translation>Teile umordnen</translation>
    </message>
    <message>
        <source>Remove part</source>
        <translation>Teil entfernen</translation>
    </message>
    <message>
        <source>Colour part</source>
        <translation>Teil färben</translation>
    </message>
    <message>
        <source>Take the usual place of growth</source>
        <translation>Üblichen Ort des Wachsens nehmen</translation>
    </message>
    <message>
        <source>Suggest pairing</source>
        <translation>Partner vorschlagen</translation>
    </message>
    <message>
        <source>Move together</source>
        <translation>Gemeinsam bewegen</translation>
    </message>
    <message>
        <source>Move separately</source>
        <translation>Getrennt bewegen</translation>
    </message>
    <message>
        <source>Import shapes</source>
        <translation>Formen importieren</translation>
    </message>
</context>
<context>
    <name>Strip</name>
    <message>
        <source>{seconds} s</source>
        <translation>{seconds} s</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
</context>
<context>
    <name>StripChart</name>
    <message>
        <source>Area, lengths and crossings over time</source>
        <translation>Fläche, Längen und Kreuzungen über die Zeit</translation>
    </message>
    <message>
        <source>Drift of area and lengths. Solid bars: frames cross themselves; hollow bars: they lie over themselves, as a coil does. Click to go there.</source>
        <translation>Abweichung von Fläche und Längen. Volle Balken: Bilder kreuzen sich selbst; hohle Balken: sie liegen über sich selbst, wie eine Spirale. Ein Klick führt dorthin.</translation>
    </message>
    <message>
        <source>{method}: lies over itself, naturally, from t = {start} to {stop}</source>
        <translation>{method}: liegt von t = {start} bis {stop} natürlich über sich selbst</translation>
    </message>
    <message>
        <source>{method}: crosses itself from t = {start} to {stop}</source>
        <translation>{method}: kreuzt sich von t = {start} bis {stop}</translation>
    </message>
</context>
<context>
    <name>TextPage</name>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
</context>
<context>
    <name>TimeSlider</name>
    <message>
        <source>Time, from source to target</source>
        <translation>Zeit, von der Quelle zum Ziel</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>What happens when the end is reached</source>
        <translation>Was am Ende geschieht</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Einmal</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Tempo beim Abspielen</translation>
    </message>
    <message>
        <source>Time t</source>
        <translation>Zeit t</translation>
    </message>
    <message>
        <source>The moment shown, from 0 (source) to 1 (target)</source>
        <translation>Der gezeigte Augenblick, von 0 (Quelle) bis 1 (Ziel)</translation>
    </message>
</context>
<context>
    <name>TimesField</name>
    <message>
        <source>Numbers from 0 to 1, set apart by spaces; empty for evenly spread ones</source>
        <translation>Zahlen von 0 bis 1, durch Leerzeichen getrennt; leer für gleichmäßig verteilte</translation>
    </message>
</context>
<context>
    <name>TolerancePage</name>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>{pixels} px</source>
        <translation>{pixels} px</translation>
    </message>
</context>
<context>
    <name>TraceDialog</name>
    <message>
        <source>Trace outline</source>
        <translation>Umriss nachzeichnen</translation>
    </message>
    <message>
        <source>What is opaque</source>
        <translation>Was deckt</translation>
    </message>
    <message>
        <source>What is dark</source>
        <translation>Was dunkel ist</translation>
    </message>
    <message>
        <source>What is light</source>
        <translation>Was hell ist</translation>
    </message>
    <message>
        <source>All parts, not the largest alone</source>
        <translation>Alle Teile, nicht nur den größten</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>&amp;Trace</source>
        <translation>&amp;Nachzeichnen</translation>
    </message>
    <message>
        <source>T&amp;hreshold</source>
        <translation>&amp;Schwelle</translation>
    </message>
    <message>
        <source>&amp;Simplify</source>
        <translation>&amp;Vereinfachen</translation>
    </message>
    <message>
        <source>Trace &amp;Outline</source>
        <translation>&amp;Umriss nachzeichnen</translation>
    </message>
    <message>
        <source>{pixels} px</source>
        <translation>{pixels} px</translation>
    </message>
</context>
<context>
    <name>TracePreview</name>
    <message>
        <source>The wheel zooms, dragging moves the picture</source>
        <translation>Das Rad vergrößert, Ziehen verschiebt das Bild</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>simple, parts overlap by {p}, area {area}</source>
        <translation>kreuzungsfrei, Teile überlappen um {p}, Fläche {area}</translation>
    </message>
    <message>
        <source>simple, parts overlap by {p}</source>
        <translation>kreuzungsfrei, Teile überlappen um {p}</translation>
    </message>
    <message>
        <source>parts overlap</source>
        <translation>Teile überlappen</translation>
    </message>
    <message>
        <source>proven simple, area {area}</source>
        <translation>bewiesen kreuzungsfrei, Fläche {area}</translation>
    </message>
    <message>
        <source>simple, area {area}</source>
        <translation>kreuzungsfrei, Fläche {area}</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>kreuzungsfrei</translation>
    </message>
    <message>
        <source>proven simple</source>
        <translation>bewiesen kreuzungsfrei</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>bewiesen</translation>
    </message>
    <message>
        <source>natural crossing, area {area}</source>
        <translation>natürliche Kreuzung, Fläche {area}</translation>
    </message>
    <message>
        <source>natural crossing</source>
        <translation>natürliche Kreuzung</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>natürlich</translation>
    </message>
    <message>
        <source>holes stray at t = {t}, area {area}</source>
        <translation>Löcher verirren sich bei t = {t}, Fläche {area}</translation>
    </message>
    <message>
        <source>holes stray at t = {t}</source>
        <translation>Löcher verirren sich bei t = {t}</translation>
    </message>
    <message>
        <source>holes stray</source>
        <translation>Löcher verirrt</translation>
    </message>
    <message>
        <source>crosses at t = {t}, area {area}</source>
        <translation>kreuzt sich bei t = {t}, Fläche {area}</translation>
    </message>
    <message>
        <source>crosses at t = {t}</source>
        <translation>kreuzt sich bei t = {t}</translation>
    </message>
    <message>
        <source>crosses</source>
        <translation>kreuzt sich</translation>
    </message>
    <message>
        <source>Area drifts by up to {p}.</source>
        <translation>Die Fläche weicht um bis zu {p} ab.</translation>
    </message>
    <message>
        <source>Edge lengths drift by {p} on average.</source>
        <translation>Die Kantenlängen weichen im Mittel um {p} ab.</translation>
    </message>
    <message>
        <source>Turning angles drift by {a} degrees on average.</source>
        <translation>Die Winkel an den Eckpunkten weichen im Mittel um {a} Grad ab.</translation>
    </message>
    <message>
        <source>Some edge has a negative length at t = {times}.</source>
        <translation>Bei t = {times} hat eine Kante negative Länge.</translation>
    </message>
    <message>
        <source>Parts cross themselves at t = {times}.</source>
        <translation>Teile überkreuzen sich selbst bei t = {times}.</translation>
    </message>
    <message>
        <source>Holes are not inside their part at t = {times}.</source>
        <translation>Löcher liegen nicht in ihrem Teil bei t = {times}.</translation>
    </message>
    <message>
        <source>No ring crosses itself or another one: proven for every t.</source>
        <translation>Kein Ring schneidet sich oder einen anderen: bewiesen für jedes t.</translation>
    </message>
    <message>
        <source>No part crosses itself, and holes stay inside.</source>
        <translation>Kein Teil überkreuzt sich, und Löcher bleiben innen.</translation>
    </message>
    <message>
        <source>Parts overlap by {p} more than at the ends.</source>
        <translation>Teile überlappen sich um {p} mehr als an den Enden.</translation>
    </message>
    <message>
        <source>Never crosses itself: proven for every t.</source>
        <translation>Kreuzt sich nie: bewiesen für jedes t.</translation>
    </message>
    <message>
        <source>No frame crosses itself.</source>
        <translation>Kein Zwischenbild kreuzt sich.</translation>
    </message>
    <message>
        <source>Crosses itself at t = {times}.</source>
        <translation>Kreuzt sich bei t = {times}.</translation>
    </message>
    <message>
        <source>That is natural: the shape lies over itself in layers.</source>
        <translation>Das ist natürlich: die Form liegt in Schichten über sich selbst.</translation>
    </message>
    <message>
        <source>Natural in {n} of {all} frames: the shape lies over itself in layers.</source>
        <translation>In {n} von {all} Zwischenbildern natürlich: die Form liegt in Schichten über sich selbst.</translation>
    </message>
    <message>
        <source>These are the frames of the stitched blend.</source>
        <translation>Das sind die Zwischenbilder der vernähten Überblendung.</translation>
    </message>
    <message>
        <source>Where the stitched blend crosses itself, it is repaired.</source>
        <translation>Wo die vernähte Überblendung sich kreuzt, ist sie ausgebessert.</translation>
    </message>
    <message>
        <source>No near repair was found: a part of the time is a convex morph.</source>
        <translation>Keine nahe Ausbesserung gefunden: Ein Teil der Zeit ist ein konvexer Übergang.</translation>
    </message>
    <message>
        <source>Vertices stay {d} units or more away from other edges.</source>
        <translation>Eckpunkte bleiben {d} Einheiten oder mehr von anderen Kanten entfernt.</translation>
    </message>
</context>
<context>
    <name>Waiting</name>
    <message>
        <source>Please wait</source>
        <translation>Bitte warten</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>Watching</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
</context>
<context>
    <name>WordField</name>
    <message>
        <source>Or write a word</source>
        <translation>Oder ein Wort schreiben</translation>
    </message>
    <message>
        <source>Set in this font, with kerning; each part of a letter becomes a part</source>
        <translation>In dieser Schrift gesetzt, mit Unterschneidung; jeder Teil eines Buchstabens wird ein Teil</translation>
    </message>
</context>
<context>
    <name>WorkIndicator</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>_FolderButton</name>
    <message>
        <source>Open Folder</source>
        <translation>Ordner öffnen</translation>
    </message>
</context>
</TS>
