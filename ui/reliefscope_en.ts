<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>reliefui::ChartsView</name>
    <message numerus="yes">
        <source> · wrong outcome: %n rays</source>
        <translation>
            <numerusform> · wrong outcome: %n ray</numerusform>
            <numerusform> · wrong outcome: %n rays</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exact: %n rays</source>
        <translation>
            <numerusform>exact: %n ray</numerusform>
            <numerusform>exact: %n rays</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>wrong outcome: %n rays</source>
        <translation>
            <numerusform>wrong outcome: %n ray</numerusform>
            <numerusform>wrong outcome: %n rays</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n rays</source>
        <translation>
            <numerusform>%1: %n ray</numerusform>
            <numerusform>%1: %n rays</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 steps: %n rays</source>
        <translation>
            <numerusform>%1 to %2 steps: %n ray</numerusform>
            <numerusform>%1 to %2 steps: %n rays</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 texels before the surface: %n rays</source>
        <translation>
            <numerusform>%1 to %2 texels before the surface: %n ray</numerusform>
            <numerusform>%1 to %2 texels before the surface: %n rays</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 texels behind it: %n rays</source>
        <translation>
            <numerusform>%1 to %2 texels behind it: %n ray</numerusform>
            <numerusform>%1 to %2 texels behind it: %n rays</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>reliefui::RangeText</name>
    <message numerus="yes">
        <source>%1 texels</source>
        <translation>
            <numerusform>%1 texel</numerusform>
            <numerusform>%1 texels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 voxels</source>
        <translation>
            <numerusform>%1 voxel</numerusform>
            <numerusform>%1 voxels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 pixel</numerusform>
            <numerusform>%1 pixels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>reliefui::ResultText</name>
    <message numerus="yes">
        <source>%1: %n pixels</source>
        <translation>
            <numerusform>%1: %n pixel</numerusform>
            <numerusform>%1: %n pixels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>reliefui::RowsView</name>
    <message numerus="yes">
        <source>%n pixels</source>
        <translation>
            <numerusform>%n pixel</numerusform>
            <numerusform>%n pixels</numerusform>
        </translation>
    </message>
</context>
</TS>
