<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Counts</name>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation>
            <numerusform>%n vertex</numerusform>
            <numerusform>%n vertices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks</source>
        <translation>
            <numerusform>%n mark</numerusform>
            <numerusform>%n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes</source>
        <translation>
            <numerusform>%n hole</numerusform>
            <numerusform>%n holes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n seconds left</source>
        <translation>
            <numerusform>about %n second left</numerusform>
            <numerusform>about %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{name} holds %n shapes.</source>
        <translation>
            <numerusform>{name} holds %n shape.</numerusform>
            <numerusform>{name} holds %n shapes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices: blending takes minutes and much memory. F5 begins, Esc ends it.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes are parts now, as they are no longer inside their outline.</source>
        <translation>
            <numerusform>%n hole is a part now, as it is no longer inside its outline.</numerusform>
            <numerusform>%n holes are parts now, as they are no longer inside their outline.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts are holes now, as they are inside another part.</source>
        <translation>
            <numerusform>%n part is a hole now, as it is inside another part.</numerusform>
            <numerusform>%n parts are holes now, as they are inside another part.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks went with this edit. Undo brings them back.</source>
        <translation>
            <numerusform>%n mark went with this edit. Undo brings it back.</numerusform>
            <numerusform>%n marks went with this edit. Undo brings them back.</numerusform>
        </translation>
    </message>
</context>
</TS>
