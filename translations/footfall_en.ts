<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>footfall::EditorWindow</name>
    <message numerus="yes">
        <source>Opened %1: %n triangle(s)</source>
        <translation>
            <numerusform>Opened %1: %n triangle</numerusform>
            <numerusform>Opened %1: %n triangles</numerusform>
        </translation>
    </message>
</context>
</TS>
