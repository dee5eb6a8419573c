<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>footfall::ui::CellLegend</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Thread %1: %2 %, %3, %n cell(s)</source>
        <translation>
            <numerusform>Thread %1: %2 %, %3, %n cell</numerusform>
            <numerusform>Thread %1: %2 %, %3, %n cells</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rank %1: %2 %, %3, %n cell(s)</source>
        <translation>
            <numerusform>Rank %1: %2 %, %3, %n cell</numerusform>
            <numerusform>Rank %1: %2 %, %3, %n cells</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::CompareFeature</name>
    <message numerus="yes">
        <source>Distances, taken at %n corners: at most %1, mean %2, root mean square %3</source>
        <translation>
            <numerusform>Distances, taken at %n corner: at most %1, mean %2, root mean square %3</numerusform>
            <numerusform>Distances, taken at %n corners: at most %1, mean %2, root mean square %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only the largest %n regions are drawn</source>
        <translation>
            <numerusform>Only the largest region is drawn</numerusform>
            <numerusform>Only the largest %n regions are drawn</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangles with the smallest distances are not drawn</source>
        <translation>
            <numerusform>%n triangle with the smallest distance is not drawn</numerusform>
            <numerusform>%n triangles with the smallest distances are not drawn</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::ComparePanel</name>
    <message numerus="yes">
        <source>The largest %1 of %n regions are listed.</source>
        <translation>
            <numerusform>The largest %1 of %n region are listed.</numerusform>
            <numerusform>The largest %1 of %n regions are listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::CorridorsPanel</name>
    <message numerus="yes">
        <source>%n places are left out from which the way gets wider by less than %1 %.</source>
        <translation>
            <numerusform>%n place is left out from which the way gets wider by less than %1 %.</numerusform>
            <numerusform>%n places are left out from which the way gets wider by less than %1 %.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n slits of at most %1 are left out.</source>
        <translation>
            <numerusform>%n slit of at most %1 is left out.</numerusform>
            <numerusform>%n slits of at most %1 are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The widest %n pieces of the map are not drawn.</source>
        <translation>
            <numerusform>The widest piece of the map is not drawn.</numerusform>
            <numerusform>The widest %n pieces of the map are not drawn.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::FilterRow</name>
    <message numerus="yes">
        <source>%n seeds</source>
        <translation>
            <numerusform>%n seed</numerusform>
            <numerusform>%n seeds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::HistogramPlot</name>
    <message numerus="yes">
        <source>%n cell(s): median %1, longest %2 (cell %3)</source>
        <translation>
            <numerusform>%n cell: median %1, longest %2 (cell %3)</numerusform>
            <numerusform>%n cells: median %1, longest %2 (cell %3)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) took %1 to %2</source>
        <translation>
            <numerusform>%n cell took %1 to %2</numerusform>
            <numerusform>%n cells took %1 to %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::LoadPanel</name>
    <message numerus="yes">
        <source>, speed-up &lt;b&gt;%1&lt;/b&gt; on %n rank(s)</source>
        <translation>
            <numerusform>, speed-up &lt;b&gt;%1&lt;/b&gt; on %n rank</numerusform>
            <numerusform>, speed-up &lt;b&gt;%1&lt;/b&gt; on %n ranks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n from the cache</source>
        <translation>
            <numerusform>%n from the cache</numerusform>
            <numerusform>%n from the cache</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::MeasurePage</name>
    <message numerus="yes">
        <source>%n run(s), nothing from caches; the timeline shows the median one.</source>
        <translation>
            <numerusform>%n run, nothing from caches; the timeline shows it.</numerusform>
            <numerusform>%n runs, nothing from caches; the timeline shows the median one.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunLog</name>
    <message numerus="yes">
        <source>Opened %1: %n triangle(s)</source>
        <translation>
            <numerusform>Opened %1: %n triangle</numerusform>
            <numerusform>Opened %1: %n triangles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunPlaces</name>
    <message numerus="yes">
        <source>%n process(es) here</source>
        <translation>
            <numerusform>%n process here</numerusform>
            <numerusform>%n processes here</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n process(es) of %1</source>
        <translation>
            <numerusform>%n process of %1</numerusform>
            <numerusform>%n processes of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n machine(s) of Slurm</source>
        <translation>
            <numerusform>%n machine of Slurm</numerusform>
            <numerusform>%n machines of Slurm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n machine(s) of %1</source>
        <translation>
            <numerusform>%n machine of %1</numerusform>
            <numerusform>%n machines of %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::SeparationText</name>
    <message numerus="yes">
        <source>It is the largest of %n obstacles on the easiest way.</source>
        <translation>
            <numerusform>It is the only obstacle on the easiest way.</numerusform>
            <numerusform>It is the largest of %n obstacles on the easiest way.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other ways lack little more.</source>
        <translation>
            <numerusform>Another way lacks little more.</numerusform>
            <numerusform>%n other ways lack little more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::SkippedFeature</name>
    <message numerus="yes">
        <source>%n polygons left out: show them</source>
        <translation>
            <numerusform>%n polygon left out: show it</numerusform>
            <numerusform>%n polygons left out: show them</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::SkippedPanel</name>
    <message numerus="yes">
        <source>%n polygons of the file were left out:</source>
        <translation>
            <numerusform>%n polygon of the file was left out:</numerusform>
            <numerusform>%n polygons of the file were left out:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n are listed.</source>
        <translation>
            <numerusform>The first one is listed.</numerusform>
            <numerusform>The first %n are listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::TurntableFeature</name>
    <message numerus="yes">
        <source>Wrote %n frames to %1</source>
        <translation>
            <numerusform>Wrote %n frame to %1</numerusform>
            <numerusform>Wrote %n frames to %1</numerusform>
        </translation>
    </message>
</context>
</TS>
