<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>the radius must be a number above 0; leave it out for an agent without a body</source>
        <translation>der Radius muss eine Zahl über 0 sein; für einen Agenten ohne Körper lassen Sie ihn weg</translation>
    </message>
    <message>
        <source>the width of passages must be a number of at least 0</source>
        <translation>die Breite von Durchgängen muss eine Zahl von mindestens 0 sein</translation>
    </message>
    <message>
        <source>node &apos;%1&apos; refers to a mesh that does not exist</source>
        <translation>Knoten „%1“ verweist auf ein Netz, das es nicht gibt</translation>
    </message>
    <message>
        <source>export the file again</source>
        <translation>exportieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>more than 4294967295 vertices</source>
        <translation>mehr als 4294967295 Ecken</translation>
    </message>
    <message>
        <source>split the file</source>
        <translation>teilen Sie die Datei</translation>
    </message>
    <message>
        <source>vertex %1 of mesh &apos;%2&apos; has a coordinate that is not finite or too large</source>
        <translation>Ecke %1 des Netzes „%2“ hat eine Koordinate, die nicht endlich oder zu groß ist</translation>
    </message>
    <message>
        <source>correct it or export the file again</source>
        <translation>berichtigen Sie das, oder exportieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>unknown content</source>
        <translation>unbekannter Inhalt</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>check that the file is complete and of the format that its extension says</source>
        <translation>prüfen Sie, ob die Datei vollständig ist und das Format hat, das ihre Endung nennt</translation>
    </message>
    <message>
        <source>an obstacle has a coordinate that is not finite; nothing was changed</source>
        <translation>Ein Hindernis hat eine Koordinate, die nicht endlich ist; es wurde nichts geändert</translation>
    </message>
    <message>
        <source>an obstacle&apos;s triangle names vertex %1 of %2; nothing was changed</source>
        <translation>Das Dreieck eines Hindernisses nennt Ecke %1 von %2; es wurde nichts geändert</translation>
    </message>
    <message>
        <source>there is no triangle %1 to remove; the environment has %2</source>
        <translation>Es gibt kein Dreieck %1 zum Entfernen; die Umgebung hat %2</translation>
    </message>
    <message>
        <source>there is no obstacle %1</source>
        <translation>Es gibt kein Hindernis %1</translation>
    </message>
    <message>
        <source>the scale of the export must be a number above 0; 1 keeps the file&apos;s units</source>
        <translation>Der Maßstab des Exports muss eine Zahl über 0 sein; 1 behält die Einheiten der Datei</translation>
    </message>
    <message>
        <source>the scale of the export makes coordinates infinite; choose a smaller one</source>
        <translation>Der Maßstab des Exports macht Koordinaten unendlich; wählen Sie einen kleineren</translation>
    </message>
    <message>
        <source>a coordinate is larger than a float of glTF can be; export as OBJ, or with a smaller scale</source>
        <translation>Eine Koordinate ist größer, als eine Zahl in glTF sein kann; exportieren Sie als OBJ oder mit einem kleineren Maßstab</translation>
    </message>
    <message>
        <source>scale: must be a positive number of metres per unit; give for example 0.01 for centimetres</source>
        <translation>Maßstab: muss eine positive Zahl von Metern je Einheit sein; geben Sie zum Beispiel 0.01 für Zentimeter</translation>
    </message>
    <message>
        <source>has no extension</source>
        <translation>hat keine Endung</translation>
    </message>
    <message>
        <source>unknown extension &apos;.%1&apos;</source>
        <translation>unbekannte Endung „.%1“</translation>
    </message>
    <message>
        <source>use OBJ, glTF, FBX, DAE, PLY, STL, 3DS or another format that Assimp reads</source>
        <translation>nehmen Sie OBJ, glTF, FBX, DAE, PLY, STL, 3DS oder ein anderes Format, das Assimp liest</translation>
    </message>
    <message>
        <source>choose a file that has faces</source>
        <translation>wählen Sie eine Datei mit Flächen</translation>
    </message>
    <message>
        <source>the file is empty (0 bytes)</source>
        <translation>die Datei ist leer (0 Bytes)</translation>
    </message>
    <message>
        <source>export it again or choose another file</source>
        <translation>exportieren Sie sie noch einmal, oder wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>keine Berechtigung zum Lesen</translation>
    </message>
    <message>
        <source>change the permissions of the file and its folders</source>
        <translation>ändern Sie die Rechte der Datei und ihrer Ordner</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>choose a file in it</source>
        <translation>wählen Sie eine Datei darin</translation>
    </message>
    <message>
        <source>is not an ordinary file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>prüfen Sie den Datenträger</translation>
    </message>
    <message>
        <source>it was cut off or changed by hand: export it again</source>
        <translation>sie wurde abgeschnitten oder von Hand geändert: exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>no triangles in it</source>
        <translation>enthält keine Dreiecke</translation>
    </message>
    <message>
        <source>a coordinate above 1e100</source>
        <translation>eine Koordinate über 1e100</translation>
    </message>
    <message>
        <source>areas and distances would overflow: choose another unit</source>
        <translation>Flächen und Abstände wären zu groß: wählen Sie eine andere Einheit</translation>
    </message>
    <message>
        <source>correct the line or export the file again</source>
        <translation>berichtigen Sie die Zeile, oder exportieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>the file ends inside this line</source>
        <translation>die Datei endet in dieser Zeile</translation>
    </message>
    <message>
        <source>it is truncated: copy or export it again</source>
        <translation>sie ist abgeschnitten: kopieren oder exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>not an OBJ statement: %1</source>
        <translation>keine OBJ-Anweisung: %1</translation>
    </message>
    <message>
        <source>is the file really OBJ? Rename it or export it again</source>
        <translation>ist die Datei wirklich OBJ? Benennen Sie sie um, oder exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>a vertex needs three coordinates</source>
        <translation>eine Ecke braucht drei Koordinaten</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>write numbers with a decimal point, and export the file again</source>
        <translation>schreiben Sie Zahlen mit einem Dezimalpunkt, und exportieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>coordinate %1 is not finite or too large</source>
        <translation>Koordinate %1 ist nicht endlich oder zu groß</translation>
    </message>
    <message>
        <source>%1 is not a face corner</source>
        <translation>%1 ist keine Ecke einer Fläche</translation>
    </message>
    <message>
        <source>vertex index 0: OBJ counts from 1</source>
        <translation>Eckennummer 0: OBJ zählt ab 1</translation>
    </message>
    <message>
        <source>vertex index %1 is out of range</source>
        <translation>Eckennummer %1 liegt außerhalb</translation>
    </message>
    <message>
        <source>has a NUL byte, so it is not OBJ text</source>
        <translation>hat ein NUL-Byte, ist also kein OBJ-Text</translation>
    </message>
    <message>
        <source>give the file the extension of its real format, or export it as plain text</source>
        <translation>geben Sie der Datei die Endung ihres wirklichen Formats, oder exportieren Sie sie als Text</translation>
    </message>
    <message>
        <source>the file names no meshes or materials</source>
        <translation>die Datei nennt keine Netze oder Materialien</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>sie hat %1</translation>
    </message>
    <message>
        <source>it has %1 and %2 more; `footfall info` lists all</source>
        <translation>sie hat %1 und %2 weitere; `footfall info` nennt alle</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: %3 has no mesh or material of that name; %4</source>
        <translation>%1 „%2“: %3 hat kein Netz oder Material dieses Namens; %4</translation>
    </message>
    <message>
        <source>obstacle &apos;%1&apos; has a number that is not finite</source>
        <translation>Hindernis „%1“ hat eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>obstacle &apos;%1&apos; has an extent that is not above 0; give a larger one</source>
        <translation>Hindernis „%1“ hat eine Ausdehnung, die nicht über 0 liegt; geben Sie eine größere</translation>
    </message>
    <message>
        <source>obstacle &apos;%1&apos; reaches too far; make it smaller</source>
        <translation>Hindernis „%1“ reicht zu weit; machen Sie es kleiner</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>wählen Sie einen anderen Ort</translation>
    </message>
    <message>
        <source>cannot be written: its folder does not exist</source>
        <translation>kann nicht geschrieben werden: Den Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>create the folder or choose another one</source>
        <translation>legen Sie den Ordner an, oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>give the name of a file in it</source>
        <translation>geben Sie den Namen einer Datei darin</translation>
    </message>
    <message>
        <source>no permission to write it</source>
        <translation>keine Berechtigung zum Schreiben</translation>
    </message>
    <message>
        <source>cannot be written: the disk is full</source>
        <translation>kann nicht geschrieben werden: Der Datenträger ist voll</translation>
    </message>
    <message>
        <source>free some space or choose another disk</source>
        <translation>schaffen Sie Platz, oder wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>no file name to write to; give one</source>
        <translation>Es fehlt der Name der Datei, die geschrieben werden soll; geben Sie einen</translation>
    </message>
    <message>
        <source>line %1 of the PLY header, &apos;%2 ...&apos;, is not understood</source>
        <translation>Zeile %1 des PLY-Kopfes, „%2 ...“, ist nicht verständlich</translation>
    </message>
    <message>
        <source>the file ends before the elements that its header announces</source>
        <translation>die Datei endet vor den Elementen, die ihr Kopf ankündigt</translation>
    </message>
    <message>
        <source>a list in the PLY file has a negative length</source>
        <translation>eine Liste in der PLY-Datei hat eine negative Länge</translation>
    </message>
    <message>
        <source>the PLY header has no end_header</source>
        <translation>dem PLY-Kopf fehlt end_header</translation>
    </message>
    <message>
        <source>the ASCII STL file does not end with endsolid</source>
        <translation>die ASCII-STL-Datei endet nicht mit endsolid</translation>
    </message>
    <message>
        <source>%1 of %2 regions removed</source>
        <translation>%1 von %2 Gebieten entfernt</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>length in the environment&apos;s units</source>
        <translation>Länge in den Einheiten der Umgebung</translation>
    </message>
    <message>
        <source>area in the environment&apos;s units</source>
        <translation>Fläche in den Einheiten der Umgebung</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a number above %1</source>
        <translation>eine Zahl über %1</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>eine Zahl von mindestens %1</translation>
    </message>
    <message>
        <source>a whole number above %1</source>
        <translation>eine ganze Zahl über %1</translation>
    </message>
    <message>
        <source>a whole number of at least %1</source>
        <translation>eine ganze Zahl von mindestens %1</translation>
    </message>
    <message>
        <source>%1 and below %2</source>
        <translation>%1 und unter %2</translation>
    </message>
    <message>
        <source>%1 and at most %2</source>
        <translation>%1 und höchstens %2</translation>
    </message>
    <message>
        <source>%1 vertices merged</source>
        <translation>Vereinte Ecken: %1</translation>
    </message>
    <message>
        <source>all vertices are exact already</source>
        <translation>Alle Ecken sind schon exakt</translation>
    </message>
    <message>
        <source>repair false changes nothing, because what rounding breaks is always repaired; footfall-rounding-experiment --no-repair leaves it</source>
        <translation>repair false ändert nichts, weil immer ausgebessert wird, was das Runden zerbricht; footfall-rounding-experiment --no-repair lässt es</translation>
    </message>
    <message>
        <source>round changes nothing, because no obstacle is cut and cuts vanish in Collapse; footfall-rounding-experiment repeats what the thesis did.</source>
        <translation>round ändert nichts, weil kein Hindernis zerschnitten wird und Schnitte im Collapse verschwinden; footfall-rounding-experiment wiederholt, was die Dissertation tat.</translation>
    </message>
    <message>
        <source>case 1: %1, case 2: %2, case 3: %3, case 4: %4, case 5: %5</source>
        <translation>Fall 1: %1, Fall 2: %2, Fall 3: %3, Fall 4: %4, Fall 5: %5</translation>
    </message>
    <message>
        <source>triangle %1 does not exist; the environment has %2</source>
        <translation>Dreieck %1 gibt es nicht; die Umgebung hat %2</translation>
    </message>
    <message>
        <source>the place has a coordinate that is not finite; give three numbers</source>
        <translation>Die Stelle hat eine Koordinate, die nicht endlich ist; geben Sie drei Zahlen</translation>
    </message>
    <message>
        <source>One cell, because one thread runs.</source>
        <translation>Eine Zelle, weil ein Thread läuft.</translation>
    </message>
    <message>
        <source>One cell, because the %1 triangles are little work: threads share its floors.</source>
        <translation>Eine Zelle, weil die %1 Dreiecke wenig Arbeit sind: Threads teilen sich ihre Böden.</translation>
    </message>
    <message>
        <source>Up to %1 cells of about equal estimated work for %2 threads, because %3 triangles are enough work to share; cut between storeys where that cuts no floor.</source>
        <translation>Bis zu %1 Zellen mit etwa gleich viel geschätzter Arbeit für %2 Threads, weil %3 Dreiecke genug Arbeit zum Teilen sind; zwischen Stockwerken geschnitten, wo das keinen Boden schneidet.</translation>
    </message>
    <message>
        <source>give fewer columns or rows</source>
        <translation>geben Sie weniger Spalten oder Zeilen</translation>
    </message>
    <message>
        <source>%1 would make more than %2 cells; %3</source>
        <translation>%1 ergäbe mehr als %2 Zellen; %3</translation>
    </message>
    <message>
        <source>give a larger min or a smaller depth</source>
        <translation>geben Sie ein größeres Minimum oder eine kleinere Tiefe</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>the parallel block that %1 begins in %2</source>
        <translation>dem parallelen Block, den %1 in %2 beginnt</translation>
    </message>
    <message>
        <source>Collapse ends no parallel block; remove it or put a strategy such as GridStrategy before it</source>
        <translation>Collapse beendet keinen parallelen Block; entfernen Sie es, oder setzen Sie eine Strategie wie GridStrategy davor</translation>
    </message>
    <message>
        <source>%1 stands inside %2; put a Collapse before it</source>
        <translation>%1 steht in %2; setzen Sie ein Collapse davor</translation>
    </message>
    <message>
        <source>%1 needs all cells and cannot run inside %2; move it behind Collapse or before the block</source>
        <translation>%1 braucht alle Zellen und kann nicht laufen in %2; setzen Sie es hinter Collapse oder vor den Block</translation>
    </message>
    <message>
        <source>%1 begins a parallel block that never ends; add a Collapse behind it</source>
        <translation>%1 beginnt einen parallelen Block, der nie endet; setzen Sie ein Collapse dahinter</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>%1 is not a finite number; give %2</source>
        <translation>%1 ist keine endliche Zahl; geben Sie %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number; give %2</source>
        <translation>%1 ist keine ganze Zahl; geben Sie %2</translation>
    </message>
    <message>
        <source>%1 %2 is out of range; give %3</source>
        <translation>%1 %2 liegt außerhalb des Bereichs; geben Sie %3</translation>
    </message>
    <message>
        <source>unknown filter %1; did you mean %2? (`footfall filters` lists them all)</source>
        <translation>Unbekannter Filter %1; war %2 gemeint? (`footfall filters` nennt alle)</translation>
    </message>
    <message>
        <source>%1 needs a value for %2; write for example &quot;%3&quot;</source>
        <translation>%1 braucht einen Wert für %2; schreiben Sie zum Beispiel „%3“</translation>
    </message>
    <message>
        <source>%1 takes no parameters; remove %2</source>
        <translation>%1 nimmt keine Parameter; entfernen Sie %2</translation>
    </message>
    <message>
        <source>%1 takes only &quot;%2&quot;; remove %3</source>
        <translation>%1 nimmt nur „%2“; entfernen Sie %3</translation>
    </message>
    <message>
        <source>%1 is no value for %2; give %3</source>
        <translation>%1 ist kein Wert für %2; geben Sie %3</translation>
    </message>
    <message>
        <source>%1: is a folder; give a pipeline file</source>
        <translation>%1: ist ein Ordner; geben Sie eine Pipeline-Datei</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2); give a pipeline file that can be read</source>
        <translation>%1: kann nicht geöffnet werden (%2); geben Sie eine lesbare Pipeline-Datei</translation>
    </message>
    <message>
        <source>%1: is too long for a pipeline; give a text file of filters</source>
        <translation>%1: ist zu lang für eine Pipeline; geben Sie eine Textdatei mit Filtern</translation>
    </message>
    <message>
        <source>%1: memory ran out; close other programs or use a smaller environment</source>
        <translation>%1: Der Speicher reicht nicht; schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
    <message>
        <source>%1: internal error (%2); please report it with the environment&apos;s file</source>
        <translation>%1: Interner Fehler (%2); bitte melden Sie ihn mit der Datei der Umgebung</translation>
    </message>
    <message>
        <source>navigation mesh</source>
        <translation>Navigationsnetz</translation>
    </message>
    <message>
        <source>environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>%1, parallel block of %2</source>
        <translation>%1, paralleler Block von %2</translation>
    </message>
    <message>
        <source>step %1 is no strategy that is switched on; choose one that is</source>
        <translation>Schritt %1 ist keine eingeschaltete Strategie; wählen Sie eine solche</translation>
    </message>
    <message>
        <source>a place is not finite</source>
        <translation>eine Stelle ist nicht endlich</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no view</source>
        <translation>„%1“ ist keine Ansicht</translation>
    </message>
    <message>
        <source>something is missing or of the wrong type</source>
        <translation>etwas fehlt oder ist von falscher Art</translation>
    </message>
    <message>
        <source>the picture cannot be made; choose a smaller size</source>
        <translation>Das Bild kann nicht erzeugt werden; wählen Sie eine kleinere Größe</translation>
    </message>
    <message>
        <source>%1: names no environment; open one first, this session brings only filters</source>
        <translation>%1: nennt keine Umgebung; öffnen Sie zuerst eine, diese Sitzung bringt nur Filter mit</translation>
    </message>
    <message>
        <source>there is no view mode &apos;%1&apos;</source>
        <translation>es gibt keine Ansichtsart „%1“</translation>
    </message>
    <message>
        <source>the cut plane has no direction</source>
        <translation>die Schnittebene hat keine Richtung</translation>
    </message>
    <message>
        <source>%1: is missing; install again</source>
        <translation>%1: fehlt; installieren Sie neu</translation>
    </message>
    <message>
        <source>unknown filter &apos;%1&apos;; see &apos;footfall filters&apos;</source>
        <translation>unbekannter Filter „%1“; siehe `footfall filters`</translation>
    </message>
    <message>
        <source>%1 has no parameter &apos;%2&apos;; see &apos;footfall filters %1&apos;</source>
        <translation>%1 hat keinen Parameter „%2“; siehe `footfall filters %1`</translation>
    </message>
    <message>
        <source>view: the orientation is no unit quaternion; remove &apos;view&apos;</source>
        <translation>view: Die Ausrichtung ist kein Einheitsquaternion; entfernen Sie „view“</translation>
    </message>
    <message>
        <source>cells: colours are &apos;%1&apos;; give thread, time, triangles or cost</source>
        <translation>cells: colours ist „%1“; geben Sie thread, time, triangles oder cost</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;; give one of %3</source>
        <translation>%1 ist „%2“; geben Sie eines von %3</translation>
    </message>
    <message>
        <source>%1 is not finite; give three numbers</source>
        <translation>%1 ist nicht endlich; geben Sie drei Zahlen</translation>
    </message>
    <message>
        <source>obstacles: a size is not above 0, or a turn not finite; mend or remove it</source>
        <translation>obstacles: Eine Größe liegt nicht über 0, oder eine Drehung ist nicht endlich; berichtigen oder entfernen Sie das</translation>
    </message>
    <message>
        <source>agents: &apos;%1&apos; needs a height above 0 and a slope between 0 and 90 degrees</source>
        <translation>agents: „%1“ braucht eine Höhe über 0 und eine Neigung zwischen 0 und 90 Grad</translation>
    </message>
    <message>
        <source>is not a session; open a file that Footfall saved</source>
        <translation>ist keine Sitzung; öffnen Sie eine Datei, die Footfall gespeichert hat</translation>
    </message>
    <message>
        <source>comes from a newer Footfall; update this one</source>
        <translation>stammt von einem neueren Footfall; bringen Sie dieses auf den neuesten Stand</translation>
    </message>
    <message>
        <source>import: metres_per_unit is not above 0; give for example 0.01</source>
        <translation>import: metres_per_unit liegt nicht über 0; geben Sie zum Beispiel 0.01</translation>
    </message>
    <message>
        <source>%1: cannot be read or is empty; choose a session that Footfall saved</source>
        <translation>%1: kann nicht gelesen werden oder ist leer; wählen Sie eine Sitzung, die Footfall gespeichert hat</translation>
    </message>
    <message>
        <source>%1: broken at byte %2; choose a session that Footfall saved</source>
        <translation>%1: fehlerhaft bei Byte %2; wählen Sie eine Sitzung, die Footfall gespeichert hat</translation>
    </message>
    <message>
        <source>%1: something is missing or of the wrong type; choose a session that Footfall saved</source>
        <translation>%1: Etwas fehlt oder ist von falscher Art; wählen Sie eine Sitzung, die Footfall gespeichert hat</translation>
    </message>
    <message>
        <source>(unnamed)</source>
        <translation>(ohne Namen)</translation>
    </message>
    <message>
        <source>the cells</source>
        <translation>die Zellen</translation>
    </message>
    <message>
        <source>the pipeline</source>
        <translation>die Pipeline</translation>
    </message>
    <message>
        <source>the corridor map</source>
        <translation>die Korridorkarte</translation>
    </message>
    <message>
        <source>the path</source>
        <translation>der Weg</translation>
    </message>
    <message>
        <source>the export</source>
        <translation>der Export</translation>
    </message>
    <message>
        <source>the statistics</source>
        <translation>die Statistik</translation>
    </message>
    <message>
        <source>the timeline</source>
        <translation>die Zeitachse</translation>
    </message>
    <message>
        <source>the report</source>
        <translation>der Bericht</translation>
    </message>
    <message>
        <source>vertex index %1 in mesh &apos;%2&apos; is out of range: it has %3</source>
        <translation>Eckennummer %1 im Netz „%2“ liegt außerhalb: Es hat %3</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 Ecke</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>no triangles in it (skipped: %1, %2, %3)</source>
        <translation>enthält keine Dreiecke (übergangen: %1, %2, %3)</translation>
    </message>
    <message>
        <source>1 polygon</source>
        <translation>1 Polygon</translation>
    </message>
    <message>
        <source>%1 polygons</source>
        <translation>%1 Polygone</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 Linie</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 Linien</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>vertices: its comments count %1, but it has %2</source>
        <translation>Ecken: Ihre Kommentare zählen %1, sie hat aber %2</translation>
    </message>
    <message>
        <source>triangles: its comments count %1, but it has %2</source>
        <translation>Dreiecke: Ihre Kommentare zählen %1, sie hat aber %2</translation>
    </message>
    <message>
        <source>layers: its comments count %1, but it has %2</source>
        <translation>Ebenen: Ihre Kommentare zählen %1, sie hat aber %2</translation>
    </message>
    <message>
        <source>connections: its comments count %1, but it has %2</source>
        <translation>Verbindungen: Ihre Kommentare zählen %1, sie hat aber %2</translation>
    </message>
    <message>
        <source>obstacle edges: its comments count %1, but it has %2</source>
        <translation>Hinderniskanten: Ihre Kommentare zählen %1, sie hat aber %2</translation>
    </message>
    <message>
        <source>vertex index %1 is out of range: only %2 before it</source>
        <translation>Eckennummer %1 liegt außerhalb: Vor ihr stehen nur %2</translation>
    </message>
    <message>
        <source>vertex index %1 is out of range: the file has %2</source>
        <translation>Eckennummer %1 liegt außerhalb: Die Datei hat %2</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>cannot be written: %1 is a file, not a folder</source>
        <translation>kann nicht geschrieben werden: %1 ist eine Datei, kein Ordner</translation>
    </message>
    <message>
        <source>cannot be written: no file can be made in its folder</source>
        <translation>kann nicht geschrieben werden: In ihrem Ordner kann keine Datei angelegt werden</translation>
    </message>
    <message>
        <source>change the permissions of the file or choose another name</source>
        <translation>ändern Sie die Rechte der Datei, oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>no permission to write in its folder</source>
        <translation>keine Berechtigung, in ihren Ordner zu schreiben</translation>
    </message>
    <message>
        <source>change the permissions of the folder or choose another one</source>
        <translation>ändern Sie die Rechte des Ordners, oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>cannot be written: its disk is read-only</source>
        <translation>kann nicht geschrieben werden: Ihr Datenträger kann nur gelesen werden</translation>
    </message>
    <message>
        <source>choose another disk</source>
        <translation>wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>cannot be written: your disk quota is used up</source>
        <translation>kann nicht geschrieben werden: Ihr Anteil am Datenträger ist aufgebraucht</translation>
    </message>
    <message>
        <source>cannot be written: it is too large for this disk</source>
        <translation>kann nicht geschrieben werden: Sie ist zu groß für diesen Datenträger</translation>
    </message>
    <message>
        <source>cannot be written: its name or path is too long</source>
        <translation>kann nicht geschrieben werden: Ihr Name oder Pfad ist zu lang</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>kürzen Sie ihn</translation>
    </message>
    <message>
        <source>cannot be written: its symbolic links form a circle</source>
        <translation>kann nicht geschrieben werden: Ihre symbolischen Verknüpfungen bilden einen Kreis</translation>
    </message>
    <message>
        <source>remove the link or choose another name</source>
        <translation>entfernen Sie die Verknüpfung, oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>cannot be written: another program uses it</source>
        <translation>kann nicht geschrieben werden: Ein anderes Programm benutzt sie</translation>
    </message>
    <message>
        <source>close that program or choose another name</source>
        <translation>schließen Sie das Programm, oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>face %1 of mesh &apos;%2&apos;</source>
        <translation>Fläche %1 des Netzes „%2“</translation>
    </message>
    <message>
        <source>has no corners; a polygon needs three</source>
        <translation>hat keine Ecken; ein Polygon braucht drei</translation>
    </message>
    <message>
        <source>has one corner; a polygon needs three</source>
        <translation>hat eine Ecke; ein Polygon braucht drei</translation>
    </message>
    <message>
        <source>has two corners; a polygon needs three</source>
        <translation>hat zwei Ecken; ein Polygon braucht drei</translation>
    </message>
    <message>
        <source>all of its %1 corners are one vertex; a polygon needs three</source>
        <translation>alle %1 Ecken sind dieselbe; ein Polygon braucht drei</translation>
    </message>
    <message>
        <source>its %1 corners are only two different vertices; a polygon needs three</source>
        <translation>seine %1 Ecken sind nur zwei verschiedene; ein Polygon braucht drei</translation>
    </message>
    <message>
        <source>a curved surface, which is not read; export it as polygons</source>
        <translation>eine gekrümmte Fläche, die nicht gelesen wird; exportieren Sie sie als Polygone</translation>
    </message>
    <message>
        <source>the environment</source>
        <translation>die Umgebung</translation>
    </message>
    <message>
        <source>a file that the environment uses</source>
        <translation>eine Datei, die die Umgebung benutzt</translation>
    </message>
    <message>
        <source>%1: would be overwritten, and is %2; give another file to write to</source>
        <translation>%1: würde überschrieben und ist %2; geben Sie eine andere Datei zum Schreiben an</translation>
    </message>
    <message>
        <source>%1: cannot hold both %2 and %3; give two files</source>
        <translation>%1: kann nicht beides aufnehmen, %2 und %3; geben Sie zwei Dateien an</translation>
    </message>
    <message>
        <source>%1: %2 writes %3 files; give a name that ends so</source>
        <translation>%1: %2 schreibt %3-Dateien; geben Sie einen Namen an, der so endet</translation>
    </message>
    <message>
        <source>%1 of 1 region removed</source>
        <translation>%1 von 1 Gebiet entfernt</translation>
    </message>
    <message>
        <source>a clearance of %1 is too small beside coordinates of up to %2; give at least %3, or check the scale and the largest coordinates</source>
        <translation>eine Durchgangshöhe von %1 ist zu klein neben Koordinaten bis %2; geben Sie mindestens %3 an, oder prüfen Sie den Maßstab und die größten Koordinaten</translation>
    </message>
    <message>
        <source>triangles without area left out: %1, walkable among them: %2</source>
        <translation>Dreiecke ohne Fläche weggelassen: %1, davon begehbar: %2</translation>
    </message>
    <message>
        <source>1 triangle without area left out; it was not walkable</source>
        <translation>1 Dreieck ohne Fläche weggelassen; es war nicht begehbar</translation>
    </message>
    <message>
        <source>%1 triangles without area left out; none was walkable</source>
        <translation>%1 Dreiecke ohne Fläche weggelassen; keines war begehbar</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>1 position</source>
        <translation>1 Stelle</translation>
    </message>
    <message>
        <source>%1 positions</source>
        <translation>%1 Stellen</translation>
    </message>
    <message>
        <source>1 vertex merged</source>
        <translation>1 Ecke zusammengelegt</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 Ebene</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 Ebenen</translation>
    </message>
    <message>
        <source>1 connection</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 Verbindungen</translation>
    </message>
    <message>
        <source>an obstacle edge without a visible wall</source>
        <translation>eine Hinderniskante ohne sichtbare Wand</translation>
    </message>
    <message>
        <source>a gap of %1</source>
        <translation>eine Lücke von %1</translation>
    </message>
    <message>
        <source>a step of %1 up</source>
        <translation>eine Stufe von %1 hinauf</translation>
    </message>
    <message>
        <source>a step of %1 down</source>
        <translation>eine Stufe von %1 hinab</translation>
    </message>
    <message>
        <source>a gap of %1 and a step of %2 up</source>
        <translation>eine Lücke von %1 und eine Stufe von %2 hinauf</translation>
    </message>
    <message>
        <source>a gap of %1 and a step of %2 down</source>
        <translation>eine Lücke von %1 und eine Stufe von %2 hinab</translation>
    </message>
    <message>
        <source>an obstacle of %1 to climb over</source>
        <translation>ein Hindernis von %1, über das man steigen muss</translation>
    </message>
    <message>
        <source>a place with only %1 of free height</source>
        <translation>eine Stelle mit nur %1 freier Höhe</translation>
    </message>
    <message>
        <source>a wall; the parts are %1 apart</source>
        <translation>eine Wand; die Teile liegen %1 auseinander</translation>
    </message>
    <message>
        <source>an obstacle edge: a wall without thickness</source>
        <translation>eine Hinderniskante: eine Wand ohne Dicke</translation>
    </message>
    <message>
        <source>the parts only touch in a point, which is too narrow for an agent</source>
        <translation>die Teile berühren sich nur in einem Punkt, der für einen Agenten zu eng ist</translation>
    </message>
    <message>
        <source>One cell, because an environment of %1 is done before cells would pay: threads share its floors.</source>
        <translation>Eine Zelle, weil die Umgebung klein ist (%1) und fertig, bevor sich Zellen lohnen: Threads teilen sich ihre Böden.</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 Dreieck</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>step %1 (%2)</source>
        <translation>Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>%1: values given: %2; give %3</source>
        <translation>%1: angegebene Werte: %2; geben Sie %3 an</translation>
    </message>
    <message>
        <source>the session that is open</source>
        <translation>die Sitzung, die geöffnet ist</translation>
    </message>
    <message>
        <source>the pipeline that is open</source>
        <translation>die Pipeline, die geöffnet ist</translation>
    </message>
    <message>
        <source>import: up is &apos;%1&apos;; give y, z, x, -y, -z or -x</source>
        <translation>import: „up“ ist „%1“; geben Sie y, z, x, -y, -z oder -x an</translation>
    </message>
    <message>
        <source>the result needs %1 bytes, more than a .glb can hold; export as .obj or .gltf</source>
        <translation>das Ergebnis braucht %1 Bytes, mehr als eine .glb-Datei fasst; als .obj oder .gltf exportieren</translation>
    </message>
    <message>
        <source>the length of %1 is %2, and the number of triangles is %3; give one entry for each triangle, or none</source>
        <translation>die Länge von %1 ist %2, die Zahl der Dreiecke ist %3; geben Sie einen Eintrag für jedes Dreieck an, oder keinen</translation>
    </message>
    <message>
        <source>the environment has no triangles</source>
        <translation>die Umgebung hat keine Dreiecke</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that is not finite; vertices count from 0</source>
        <translation>Ecke %1 hat eine Koordinate, die nicht endlich ist; Ecken zählen ab 0</translation>
    </message>
    <message>
        <source>triangle %1 names vertex %2 of %3; both count from 0</source>
        <translation>Dreieck %1 nennt Ecke %2 von %3; beide zählen ab 0</translation>
    </message>
    <message>
        <source>metresPerUnit must be a positive number of metres</source>
        <translation>metresPerUnit muss eine positive Zahl von Metern sein</translation>
    </message>
    <message>
        <source>partOf names part %1 of %2; parts count from 0</source>
        <translation>partOf nennt Teil %1 von %2; Teile zählen ab 0</translation>
    </message>
    <message>
        <source>there is no triangle %1; the mesh has %2</source>
        <translation>Dreieck %1 gibt es nicht; das Netz hat %2</translation>
    </message>
    <message>
        <source>the place does not lie in triangle %1; give a place of this mesh</source>
        <translation>der Ort liegt nicht im Dreieck %1; einen Ort dieses Netzes angeben</translation>
    </message>
    <message>
        <source>agent: %1</source>
        <translation>Agent: %1</translation>
    </message>
    <message>
        <source>agent: %1, in metres</source>
        <translation>Agent: %1, in Metern</translation>
    </message>
    <message>
        <source>agent: %1, in square metres</source>
        <translation>Agent: %1, in Quadratmetern</translation>
    </message>
    <message>
        <source>agent, in the environment&apos;s units: %1</source>
        <translation>Agent, in den Einheiten der Umgebung: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that can stand here</source>
        <translation>„%1“ ist keine Zahl, die hier stehen kann</translation>
    </message>
    <message>
        <source>the line ends before its element</source>
        <translation>die Zeile endet vor ihrem Element</translation>
    </message>
    <message>
        <source>a list has more entries than its line has numbers</source>
        <translation>eine Liste hat mehr Einträge, als ihre Zeile Zahlen hat</translation>
    </message>
    <message>
        <source>the line is empty, but an element of the PLY file must stand there</source>
        <translation>die Zeile ist leer, aber dort muss ein Element der PLY-Datei stehen</translation>
    </message>
    <message>
        <source>the PLY file is declared as ASCII, but the line has bytes that are not text</source>
        <translation>die PLY-Datei nennt sich ASCII, aber in der Zeile stehen Bytes, die kein Text sind</translation>
    </message>
    <message>
        <source>there is something before the word &apos;ply&apos; with which a PLY file must begin</source>
        <translation>vor dem Wort „ply“, mit dem eine PLY-Datei beginnen muss, steht etwas</translation>
    </message>
    <message>
        <source>the data behind the unknown PLY elements &apos;%1&apos; cannot be read</source>
        <translation>die Daten hinter den unbekannten PLY-Elementen „%1“ können nicht gelesen werden</translation>
    </message>
    <message>
        <source>move them behind all others or export the file without them</source>
        <translation>stellen Sie sie hinter alle anderen, oder exportieren Sie die Datei ohne sie</translation>
    </message>
    <message>
        <source>a step of %1 is too small beside coordinates of up to %2; give at least %3, or check the scale and the largest coordinates</source>
        <translation>eine Stufe von %1 ist zu klein neben Koordinaten bis %2; geben Sie mindestens %3 an, oder prüfen Sie den Maßstab und die größten Koordinaten</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Verbindung über Stufen</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 Verbindungen über Stufen</translation>
    </message>
    <message>
        <source>%1; short ways over gaps left out, as they lead nowhere else: %2</source>
        <translation>%1; kurze Wege über Lücken weggelassen, da sie nirgendwo anders hinführen: %2</translation>
    </message>
    <message>
        <source>steps: its comments count %1, but it has %2</source>
        <translation>Stufen: die Kommentare nennen %1, aber es sind %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number (%1)</source>
        <translation>eine Zahl (%1)</translation>
    </message>
    <message>
        <source>the radius is too small for the largest coordinates; give at least %1, or check the scale and the largest coordinates</source>
        <translation>der Radius ist zu klein für die größten Koordinaten; geben Sie mindestens %1 an, oder prüfen Sie Maßstab und größte Koordinaten</translation>
    </message>
    <message>
        <source>nothing is left: no place is far enough from all borders</source>
        <translation>nichts ist übrig: keine Stelle ist weit genug von allen Rändern weg</translation>
    </message>
    <message>
        <source>seed %1 at %2 %3 %4</source>
        <translation>Startpunkt %1 bei %2 %3 %4</translation>
    </message>
    <message>
        <source>%1 has no walkable place under it; move it over one, or remove it</source>
        <translation>unter %1 ist keine begehbare Stelle; verschieben Sie ihn über eine oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>%1 is %2 above the next walkable place, more than the clearance of %3; move it nearer to a walkable place, or remove it</source>
        <translation>%1 liegt %2 über der nächsten begehbaren Stelle, mehr als die Durchgangshöhe von %3; verschieben Sie ihn näher zu einer begehbaren Stelle oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>most risers here are %1 high, a little more than the step, and are not climbed; give %2</source>
        <translation>die meisten Setzstufen sind hier %1 hoch, ein wenig mehr als die Stufe, und werden nicht gestiegen; geben Sie %2 an</translation>
    </message>
    <message>
        <source>most risers here are %1 high, as the step is, and roundings make %2 of %3 a little higher, which are not climbed; give %4</source>
        <translation>die meisten Setzstufen sind hier %1 hoch wie die Stufe, und Rundungen machen %2 von %3 ein wenig höher, die nicht gestiegen werden; geben Sie %4 an</translation>
    </message>
    <message>
        <source>the scale is a guess that makes the level %1 m high; give the metres of a unit, perhaps %2</source>
        <translation>der Maßstab ist eine Annahme, nach der das Level %1 m hoch ist; geben Sie die Meter je Einheit an, vielleicht %2</translation>
    </message>
    <message>
        <source>the scale is a guess that makes the level %1 m long; give the metres of a unit, perhaps %2</source>
        <translation>der Maßstab ist eine Annahme, nach der das Level %1 m lang ist; geben Sie die Meter je Einheit an, vielleicht %2</translation>
    </message>
    <message>
        <source>the whole level is no larger than %1 m, less than ten times an agent&apos;s height of %2 m; if its unit is larger, give the metres of a unit, perhaps %3</source>
        <translation>das ganze Level ist nicht größer als %1 m, weniger als das Zehnfache der Größe eines Agenten von %2 m; wenn seine Einheit größer ist, geben Sie die Meter je Einheit an, vielleicht %3</translation>
    </message>
    <message>
        <source>the level is %1 m large; if its unit is smaller, give the metres of a unit, perhaps %2</source>
        <translation>das Level ist %1 m groß; wenn seine Einheit kleiner ist, geben Sie die Meter je Einheit an, vielleicht %2</translation>
    </message>
    <message>
        <source>%1 square metres of ramps are steeper than %2 degrees by less than %3 degrees, and are not walkable; for a tolerance of %3 give SlopeFilter %2 %3</source>
        <translation>%1 Quadratmeter Rampen sind um weniger als %3 Grad steiler als %2 Grad und nicht begehbar; für eine Toleranz von %3 geben Sie SlopeFilter %2 %3 an</translation>
    </message>
    <message>
        <source>an area of %1 is steeper than the limit by less than 0.05 degrees</source>
        <translation>eine Fläche von %1 ist um weniger als 0,05 Grad steiler als die Grenze</translation>
    </message>
    <message>
        <source>grid: the step must be a positive number; give for example 0.001</source>
        <translation>Raster: Der Schritt muss eine positive Zahl sein; geben Sie zum Beispiel 0.001 an</translation>
    </message>
    <message>
        <source>the coordinates</source>
        <translation>die Koordinaten</translation>
    </message>
    <message>
        <source>import: grid is &apos;%1&apos;; give auto, on, off or a step</source>
        <translation>Import: grid ist „%1“; geben Sie auto, on, off oder einen Schritt an</translation>
    </message>
    <message>
        <source>import: a step of the grid is not above 0; give for example 0.001</source>
        <translation>Import: Ein Schritt des Rasters ist nicht größer als 0; geben Sie zum Beispiel 0.001 an</translation>
    </message>
    <message>
        <source>%1, %2 too low</source>
        <translation>%1, %2 zu niedrig</translation>
    </message>
    <message>
        <source>%1, %2 too high</source>
        <translation>%1, %2 zu hoch</translation>
    </message>
    <message>
        <source>%1; low enough, but StepFilter does not link it</source>
        <translation>%1; niedrig genug, aber StepFilter verbindet sie nicht</translation>
    </message>
    <message>
        <source>%1 has no seed; give the coordinates of a walkable place, or click one in the editor</source>
        <translation>%1 hat keinen Startpunkt; geben Sie die Koordinaten einer begehbaren Stelle an oder klicken Sie im Editor auf eine</translation>
    </message>
    <message>
        <source>%1 takes &quot;%2&quot;; values given: %3; give a multiple of %4</source>
        <translation>%1 nimmt „%2“; gegebene Werte: %3; geben Sie ein Vielfaches von %4 an</translation>
    </message>
    <message>
        <source>%1: values given: %2; give a multiple of %3</source>
        <translation>%1: gegebene Werte: %2; geben Sie ein Vielfaches von %3 an</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>Spalte %1: %2</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; has %3 values; give a multiple of %4</source>
        <translation>%1: „%2“ hat %3 Werte; geben Sie ein Vielfaches von %4 an</translation>
    </message>
    <message>
        <source>agents: the step of &apos;%1&apos; is below 0; give 0 or more</source>
        <translation>Agenten: die Stufe von „%1“ ist kleiner als 0; geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>the height must be a length in the files&apos; units: 0 or more</source>
        <translation>die Höhe muss eine Länge in den Einheiten der Dateien sein: 0 oder mehr</translation>
    </message>
    <message>
        <source>the error must be a length in the files&apos; units: above 0</source>
        <translation>der Fehler muss eine Länge in den Einheiten der Dateien sein: über 0</translation>
    </message>
    <message>
        <source>a drop of %1 is too small beside coordinates of up to %2; give at least %3, or check the scale and the largest coordinates</source>
        <translation>ein Sprung von %1 ist zu klein neben Koordinaten bis %2; geben Sie mindestens %3 an, oder prüfen Sie den Maßstab und die größten Koordinaten</translation>
    </message>
    <message>
        <source>1 drop</source>
        <translation>1 Sprung</translation>
    </message>
    <message>
        <source>%1 drops</source>
        <translation>%1 Sprünge</translation>
    </message>
    <message>
        <source>drops are %1 deep at most, and the whole level is no higher than %2; check the scale</source>
        <translation>Sprünge sind höchstens %1 tief, und das ganze Level ist nicht höher als %2; prüfen Sie den Maßstab</translation>
    </message>
    <message>
        <source>gaps: its comments count %1, but it has %2</source>
        <translation>Lücken: Seine Kommentare zählen %1, es hat aber %2</translation>
    </message>
    <message>
        <source>drops: its comments count %1, but it has %2</source>
        <translation>Sprünge: die Kommentare nennen %1, aber es sind %2</translation>
    </message>
    <message>
        <source>%1 would lose the drops of the DropFilter in %2; put it before that</source>
        <translation>%1 würde die Sprünge des DropFilters in %2 verlieren; stellen Sie ihn davor</translation>
    </message>
    <message>
        <source>agents: the gap of &apos;%1&apos; is below 0; give 0 or more</source>
        <translation>Agenten: Die Lücke von „%1“ ist kleiner als 0; geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>agents: the radius of &apos;%1&apos; is below 0; give 0 or more</source>
        <translation>Agenten: der Radius von &apos;%1&apos; ist unter 0; 0 oder mehr angeben</translation>
    </message>
    <message>
        <source>agents: the drop of &apos;%1&apos; is below 0; give 0 or more</source>
        <translation>Agenten: der Sprung von „%1“ ist kleiner als 0; geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>one of the two meshes</source>
        <translation>eines der beiden Netze</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>das Bild</translation>
    </message>
    <message>
        <source>the floor plan</source>
        <translation>der Grundriss</translation>
    </message>
    <message>
        <source>no other program can be started (%1)</source>
        <translation>es lässt sich kein anderes Programm starten (%1)</translation>
    </message>
    <message>
        <source>the length of usualRoles is %1, and the number of parts is %2; give one entry for each part, or none</source>
        <translation>die Länge von usualRoles ist %1, die Zahl der Teile ist %2; geben Sie einen Eintrag für jeden Teil an, oder keinen</translation>
    </message>
    <message>
        <source>agents are %1 high, and the highest doorway here is %2: nobody gets through one; give %2 or less</source>
        <translation>Agenten sind %1 hoch, und die höchste Türöffnung hier misst %2: Niemand kommt hindurch; geben Sie höchstens %2 an</translation>
    </message>
    <message>
        <source>agents are %1 wide, and the whole level is no wider than %2: nothing will be left; check the scale</source>
        <translation>Agenten sind %1 breit, und das ganze Level ist nicht breiter als %2: Nichts bleibt übrig; prüfen Sie den Maßstab</translation>
    </message>
    <message>
        <source>agents are %1 wide, and the widest doorway here is %2: nobody gets through one; give a radius below %3</source>
        <translation>Agenten sind %1 breit, und die breiteste Türöffnung hier misst %2: Niemand kommt hindurch; geben Sie einen Radius unter %3 an</translation>
    </message>
    <message>
        <source>divide it</source>
        <translation>ihn aufteilen</translation>
    </message>
    <message>
        <source>a unit of it is %1 metres, and one of %2 is %3</source>
        <translation>eine Einheit darin ist %1 Meter, und eine von %2 ist %3</translation>
    </message>
    <message>
        <source>give one scale for all of them, or export them in one unit</source>
        <translation>einen Maßstab für alle angeben, oder sie in einer Einheit exportieren</translation>
    </message>
    <message>
        <source>a folder without meshes</source>
        <translation>ein Ordner ohne Netze</translation>
    </message>
    <message>
        <source>choose a file, or a folder with OBJ, glTF or other meshes directly in it</source>
        <translation>eine Datei wählen, oder einen Ordner, der unmittelbar OBJ, glTF oder andere Netze enthält</translation>
    </message>
    <message>
        <source>Detour does not take the mesh; export as .obj or .glb, and report it, please</source>
        <translation>Detour nimmt das Netz nicht an; exportieren Sie als .obj oder .glb, und melden Sie es bitte</translation>
    </message>
    <message>
        <source>this program was built without Detour and cannot write .bin; install librecast-dev and build it again, or export as .obj or .glb</source>
        <translation>dieses Programm wurde ohne Detour gebaut und kann kein .bin schreiben; installieren Sie librecast-dev und bauen Sie es neu, oder exportieren Sie als .obj oder .glb</translation>
    </message>
    <message>
        <source>no place to cut the mesh into tiles for Detour; export with another scale</source>
        <translation>kein Platz, um das Netz für Detour in Kacheln zu teilen; exportieren Sie mit anderem Maßstab</translation>
    </message>
    <message>
        <source>the mesh has too many polygons for one file of Detour; simplify it, or export parts of it</source>
        <translation>das Netz hat zu viele Polygone für eine Datei von Detour; vereinfachen Sie es oder exportieren Sie Teile davon</translation>
    </message>
    <message>
        <source>a coordinate is larger than a float can be; export as OBJ, or with a smaller scale</source>
        <translation>eine Koordinate ist größer, als einfache Genauigkeit erlaubt; exportieren Sie als OBJ oder mit kleinerem Maßstab</translation>
    </message>
    <message>
        <source>Wavefront OBJ: exact, in the file&apos;s frame</source>
        <translation>Wavefront OBJ: exakt, im Bezugssystem der Datei</translation>
    </message>
    <message>
        <source>everything, in doubles; footfall compare and other tools read it back</source>
        <translation>alles, in doppelter Genauigkeit; footfall compare und andere Programme lesen es wieder</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>glTF, text: metres, Y up</source>
        <translation>glTF, Text: Meter, Y nach oben</translation>
    </message>
    <message>
        <source>everything, in metres; agent, areas and links as extras</source>
        <translation>alles, in Metern; Agent, Flächen und Verbindungen als Extras</translation>
    </message>
    <message>
        <source>glTF, binary: metres, Y up</source>
        <translation>glTF, binär: Meter, Y nach oben</translation>
    </message>
    <message>
        <source>Detour: tile set, metres, Y up</source>
        <translation>Detour: Kachelsatz, Meter, Y nach oben</translation>
    </message>
    <message>
        <source>convex polygons with their connections, heights, steps, drops, the agent; layers as areas</source>
        <translation>konvexe Polygone mit ihren Verbindungen, Höhen, Stufen, Sprünge nach unten, der Agent; Ebenen als Areas</translation>
    </message>
    <message>
        <source>Godot: NavigationMesh, metres, Y up</source>
        <translation>Godot: NavigationMesh, Meter, Y nach oben</translation>
    </message>
    <message>
        <source>convex polygons, steps as polygons, the agent</source>
        <translation>konvexe Polygone, Stufen als Polygone, der Agent</translation>
    </message>
    <message>
        <source>%1: cannot be written in the format &quot;%2&quot;; give a name that ends in %3</source>
        <translation>%1: kann nicht im Format „%2“ geschrieben werden; geben Sie einen Namen an, der auf %3 endet</translation>
    </message>
    <message>
        <source>the area of 1 layer</source>
        <translation>die Area von 1 Ebene</translation>
    </message>
    <message>
        <source>the areas of %1 layers</source>
        <translation>die Areas von %1 Ebenen</translation>
    </message>
    <message>
        <source>%1: not the name of a coordinate system; give one such as EPSG:25832</source>
        <translation>%1: nicht der Name eines Koordinatensystems; einen wie EPSG:25832 angeben</translation>
    </message>
    <message>
        <source>there is no format for Godot %1; choose 3 or 4</source>
        <translation>es gibt kein Format für Godot %1; wählen Sie 3 oder 4</translation>
    </message>
    <message>
        <source>%1: already exists and is not a navigation mesh; choose another name</source>
        <translation>%1: gibt es schon und ist kein Navigationsnetz; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>a file that ends in %1 cannot hold placed obstacles; leave them out, or export as .obj or .glb</source>
        <translation>eine Datei, die auf %1 endet, kann keine platzierten Hindernisse enthalten; lassen Sie sie weg oder exportieren Sie als .obj oder .glb</translation>
    </message>
    <message>
        <source>IFC files are read by a converter that needs Node.js, which cannot be started</source>
        <translation>IFC-Dateien liest ein Umwandler, der Node.js braucht, und das lässt sich nicht starten</translation>
    </message>
    <message>
        <source>install it (package nodejs)</source>
        <translation>es installieren (Paket nodejs)</translation>
    </message>
    <message>
        <source>cannot be converted (exit status %1)</source>
        <translation>lässt sich nicht umwandeln (Rückgabewert %1)</translation>
    </message>
    <message>
        <source>check that the file is complete, or export it again</source>
        <translation>prüfen, ob die Datei vollständig ist, oder sie neu exportieren</translation>
    </message>
    <message>
        <source>its converter %1 is of another version</source>
        <translation>ihr Umwandler %1 gehört zu einer anderen Version</translation>
    </message>
    <message>
        <source>to install it, type in a terminal: %1</source>
        <translation>zum Installieren in ein Terminal eingeben: %1</translation>
    </message>
    <message>
        <source>IFC is read without its converter: openings may be closed, doors are in the way, and elements have no classes or storeys; %1</source>
        <translation>IFC wird ohne Umwandler gelesen: Öffnungen können geschlossen sein, Türen sind im Weg, und Bauteile haben weder Klassen noch Geschosse; %1</translation>
    </message>
    <message>
        <source>%1; valid IFC files may need the converter of Footfall; %2</source>
        <translation>%1; gültige IFC-Dateien brauchen vielleicht den Umwandler von Footfall; %2</translation>
    </message>
    <message>
        <source>it has no floors and no obstacles</source>
        <translation>sie hat weder Böden noch Hindernisse</translation>
    </message>
    <message>
        <source>choose a file that has walls, slabs or stairs</source>
        <translation>eine Datei mit Wänden, Decken oder Treppen wählen</translation>
    </message>
    <message>
        <source>glTF has numbers of 24 bits and no exact surfaces, and its steps and drops are not read</source>
        <translation>glTF hat Zahlen mit 24 Bit und keine exakten Flächen, und seine Stufen und Sprünge werden nicht gelesen</translation>
    </message>
    <message>
        <source>export as OBJ, which holds all of it</source>
        <translation>exportieren Sie als OBJ, das all das enthält</translation>
    </message>
    <message>
        <source>%1: would be a part of the environment, which is all meshes in its folder; give a file in another folder</source>
        <translation>%1: würde ein Teil der Umgebung, die aus allen Netzen ihres Ordners besteht; eine Datei in einem anderen Ordner angeben</translation>
    </message>
    <message>
        <source>%1, %2 too wide</source>
        <translation>%1, %2 zu breit</translation>
    </message>
    <message>
        <source>%1; narrow and low enough, but StepFilter does not link it</source>
        <translation>%1; schmal und niedrig genug, aber StepFilter verbindet es nicht</translation>
    </message>
    <message>
        <source>nothing is walkable, so there is no plan; change the filters, or look up the reason for a place with Why</source>
        <translation>nichts ist begehbar, also gibt es keinen Plan; ändern Sie die Filter, oder lassen Sie sich mit Warum den Grund für eine Stelle zeigen</translation>
    </message>
    <message>
        <source>%1: not the name of a floor plan; give one that ends in .svg, .pdf, .wkt or .geojson</source>
        <translation>%1: kein Name für einen Grundriss; einen angeben, der auf .svg, .pdf, .wkt oder .geojson endet</translation>
    </message>
    <message>
        <source>the plan does not fit the paper at %1; choose %2 or a larger paper</source>
        <translation>der Plan passt bei %1 nicht auf das Papier; %2 oder ein größeres Papier wählen</translation>
    </message>
    <message>
        <source>the PDF file cannot be made: not enough memory</source>
        <translation>die PDF-Datei kann nicht erzeugt werden: nicht genug Speicher</translation>
    </message>
    <message>
        <source>the PDF file cannot be made: error %1 of libharu</source>
        <translation>die PDF-Datei kann nicht erzeugt werden: Fehler %1 von libharu</translation>
    </message>
    <message>
        <source>rank %1: %2</source>
        <translation>Rang %1: %2</translation>
    </message>
    <message>
        <source>this rank has other inputs than rank 0: another file of the environment, another pipeline or another version of the program; give all ranks the same</source>
        <translation>Dieser Rang hat andere Eingaben als Rang 0: eine andere Datei der Umgebung, eine andere Pipeline oder eine andere Version des Programms; geben Sie allen Rängen dasselbe</translation>
    </message>
    <message>
        <source>%1. The run goes on; if it is killed, this part is lost</source>
        <translation>%1. Der Lauf geht weiter; wird er abgebrochen, ist dieser Teil verloren</translation>
    </message>
    <message>
        <source>%1: this folder for shares cannot be made (%2); name a folder that can be written</source>
        <translation>%1: Dieser Ordner für Anteile kann nicht angelegt werden (%2); nennen Sie einen Ordner, in den geschrieben werden kann</translation>
    </message>
    <message>
        <source>%1 %2; its cell runs again</source>
        <translation>%1 %2; die Zelle wird noch einmal berechnet</translation>
    </message>
    <message>
        <source>Well-known text: polygons with holes, metres</source>
        <translation>Well-known Text: Polygone mit Löchern, Meter</translation>
    </message>
    <message>
        <source>polygons with holes, a file for each layer, in doubles; connections, steps, gaps, drops and thin walls as lines in another file</source>
        <translation>Polygone mit Löchern, eine Datei für jede Ebene, in doppelter Genauigkeit; Übergänge, Stufen, Lücken, Sprünge nach unten und dünne Wände als Linien in einer weiteren Datei</translation>
    </message>
    <message>
        <source>heights, triangles, what links lead to, the agent, placed obstacles</source>
        <translation>Höhen, Dreiecke, wohin Verbindungen führen, den Agenten, gesetzte Hindernisse</translation>
    </message>
    <message>
        <source>GeoJSON: polygons with holes, metres</source>
        <translation>GeoJSON: Polygone mit Löchern, Meter</translation>
    </message>
    <message>
        <source>polygons with holes and heights, layer, part and area of each, in doubles; connections, steps, gaps, drops and thin walls as lines</source>
        <translation>Polygone mit Löchern und Höhen, je mit Ebene, Teil und Flächeninhalt, in doppelter Genauigkeit; Übergänge, Stufen, Lücken, Sprünge nach unten und dünne Wände als Linien</translation>
    </message>
    <message>
        <source>triangles, the agent, placed obstacles</source>
        <translation>Dreiecke, den Agenten, gesetzte Hindernisse</translation>
    </message>
    <message>
        <source>a file that ends in %1 has no choice of %2; leave that out</source>
        <translation>eine Datei, die auf %1 endet, lässt keine Wahl zu: %2; lassen Sie das weg</translation>
    </message>
    <message>
        <source>an up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>a version of Godot</source>
        <translation>Version von Godot</translation>
    </message>
    <message>
        <source>a node for Godot</source>
        <translation>Knoten für Godot</translation>
    </message>
    <message>
        <source>a connected part</source>
        <translation>zusammenhängender Teil</translation>
    </message>
    <message>
        <source>a coordinate system</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>%1 threads are out of range; give 1 to %2, or 0 for as many as the machine has</source>
        <translation>%1 Threads liegen außerhalb des Bereichs; geben Sie 1 bis %2 an, oder 0 für so viele, wie der Rechner hat</translation>
    </message>
    <message>
        <source>a memory of %1 is probably too little for layers, which come last; %2 are probably enough</source>
        <translation>ein Speicher von %1 ist wahrscheinlich zu wenig für die Ebenen, die zuletzt kommen; %2 sind wahrscheinlich genug</translation>
    </message>
    <message>
        <source>coordinates of very different sizes need %1 bits together, and runs take many times longer; put them on a grid when the file is read, or check the largest and the smallest ones</source>
        <translation>Koordinaten sehr verschiedener Größe brauchen zusammen %1 Bit, und Läufe dauern um ein Vielfaches länger; legen Sie sie beim Lesen der Datei auf ein Raster, oder prüfen Sie die größten und die kleinsten</translation>
    </message>
    <message>
        <source>there is no connected part %1, the last is %2; choose another one</source>
        <translation>es gibt keinen zusammenhängenden Teil %1, der letzte ist %2; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>its glTF is damaged</source>
        <translation>seine glTF-Daten sind beschädigt</translation>
    </message>
    <message>
        <source>a drawing to scale, all pages in one file: walkable area, walls, steps, drops, doors, areas</source>
        <translation>eine Zeichnung im Maßstab, alle Seiten in einer Datei: begehbare Fläche, Wände, Stufen, Sprünge nach unten, Türen, Flächeninhalte</translation>
    </message>
    <message>
        <source>a drawing to scale, a file for each page: walkable area, walls, steps, drops, doors, areas</source>
        <translation>eine Zeichnung im Maßstab, eine Datei für jede Seite: begehbare Fläche, Wände, Stufen, Sprünge nach unten, Türen, Flächeninhalte</translation>
    </message>
    <message>
        <source>data for other programs; letters beyond Western Europe&apos;s</source>
        <translation>Daten für andere Programme; Buchstaben außerhalb Westeuropas</translation>
    </message>
    <message>
        <source>data for other programs: heights, connectivity</source>
        <translation>Daten für andere Programme: Höhen, Verbindungen</translation>
    </message>
    <message>
        <source>this program was built without libharu and cannot write .pdf; install libhpdf-dev and build it again, or draw the plan as .svg</source>
        <translation>dieses Programm wurde ohne libharu gebaut und kann kein .pdf schreiben; installieren Sie libhpdf-dev, und bauen Sie es neu, oder zeichnen Sie den Plan als .svg</translation>
    </message>
    <message>
        <source>lengths are in &apos;%1&apos;; give metres, millimetres, feet or file</source>
        <translation>Längen sind in „%1“; geben Sie metres, millimetres, feet oder file an</translation>
    </message>
    <message>
        <source>%1: not written, as it was cancelled; export again</source>
        <translation>%1: nicht geschrieben, weil abgebrochen wurde; exportieren Sie noch einmal</translation>
    </message>
    <message>
        <source>%1: already exists; export with the dialog, which asks whether to replace it</source>
        <translation>%1: Diese Datei gibt es schon; exportieren Sie über den Dialog, der fragt, ob sie ersetzt werden soll</translation>
    </message>
    <message>
        <source>A mesh for each layer</source>
        <translation>Ein Netz je Ebene</translation>
    </message>
    <message>
        <source>Layers as areas</source>
        <translation>Ebenen als Areas</translation>
    </message>
    <message>
        <source>Steps that can be crossed</source>
        <translation>Stufen, die man überqueren kann</translation>
    </message>
    <message>
        <source>Steps as polygons</source>
        <translation>Stufen als Polygone</translation>
    </message>
    <message>
        <source>A file for each layer</source>
        <translation>Eine Datei je Ebene</translation>
    </message>
    <message>
        <source>Steps as lines</source>
        <translation>Stufen als Linien</translation>
    </message>
    <message>
        <source>The layer of each polygon</source>
        <translation>Die Ebene jedes Polygons</translation>
    </message>
    <message>
        <source>A group for each layer</source>
        <translation>Eine Gruppe je Ebene</translation>
    </message>
    <message>
        <source>Steps as faces</source>
        <translation>Stufen als Flächen</translation>
    </message>
    <message>
        <source>the processes ended, and their results are not in %1; name a folder that all of them see</source>
        <translation>die Prozesse sind zu Ende, und ihre Ergebnisse sind nicht in %1; einen Ordner nennen, den sie alle sehen</translation>
    </message>
    <message>
        <source>the share of cell %1 that arrived cannot be used (%2); give all processes the same version of the program</source>
        <translation>der Anteil von Zelle %1, der ankam, ist nicht zu verwenden (%2); allen Prozessen dieselbe Version des Programms geben</translation>
    </message>
    <message>
        <source>%1 %2; use the same version of Footfall everywhere, and a folder that all processes see</source>
        <translation>%1 %2; überall dieselbe Version von Footfall verwenden, und einen Ordner, den alle Prozesse sehen</translation>
    </message>
    <message>
        <source>%1 was not found; install the package footfall-mpi, or run on this program alone</source>
        <translation>%1 wurde nicht gefunden; das Paket footfall-mpi installieren oder nur mit diesem Programm rechnen</translation>
    </message>
    <message>
        <source>%1 was not found; Slurm has to be installed on this machine, too</source>
        <translation>%1 wurde nicht gefunden; Slurm muss auch auf diesem Rechner installiert sein</translation>
    </message>
    <message>
        <source>%1 was not found; install Open MPI (Debian: openmpi-bin)</source>
        <translation>%1 wurde nicht gefunden; Open MPI installieren (Debian: openmpi-bin)</translation>
    </message>
    <message>
        <source>%1: this host file cannot be read; name a file with a machine in each line</source>
        <translation>%1: diese Rechnerliste ist nicht lesbar; eine Datei mit einem Rechner je Zeile nennen</translation>
    </message>
    <message>
        <source>%1 ended with exit code %2</source>
        <translation>%1 endete mit Code %2</translation>
    </message>
    <message>
        <source>%1 (exit code %2 of %3)</source>
        <translation>%1 (Code %2 von %3)</translation>
    </message>
    <message>
        <source>run_on is &apos;%1&apos;; give this_program, processes, hosts or slurm</source>
        <translation>run_on ist &apos;%1&apos;; this_program, processes, hosts oder slurm angeben</translation>
    </message>
    <message>
        <source>run_on: %1 processes; give 1 to %2</source>
        <translation>run_on: %1 Prozesse; 1 bis %2 angeben</translation>
    </message>
    <message>
        <source>more than 4294967295 triangles</source>
        <translation>mehr als 4294967295 Dreiecke</translation>
    </message>
    <message>
        <source>copy it again, or pack the original again</source>
        <translation>kopieren Sie sie noch einmal, oder packen Sie das Original noch einmal</translation>
    </message>
    <message>
        <source>it was cut off while it was open</source>
        <translation>sie wurde abgeschnitten, während sie offen war</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>sie ist beschädigt</translation>
    </message>
    <message>
        <source>the packed environment is cut off</source>
        <translation>die gepackte Umgebung ist abgeschnitten</translation>
    </message>
    <message>
        <source>is no packed environment, or is cut off</source>
        <translation>ist keine gepackte Umgebung oder ist abgeschnitten</translation>
    </message>
    <message>
        <source>is no packed environment</source>
        <translation>ist keine gepackte Umgebung</translation>
    </message>
    <message>
        <source>give the file the extension of its real format</source>
        <translation>geben Sie der Datei die Endung ihres wirklichen Formats</translation>
    </message>
    <message>
        <source>is a packed environment of version %1, and this program reads versions up to %2</source>
        <translation>ist eine gepackte Umgebung der Version %1, und dieses Programm liest Versionen bis %2</translation>
    </message>
    <message>
        <source>pack the original again with this program, or use the one that packed it</source>
        <translation>packen Sie das Original noch einmal mit diesem Programm, oder nehmen Sie das, mit dem sie gepackt wurde</translation>
    </message>
    <message>
        <source>%1: is not an ordinary file; choose a file</source>
        <translation>%1: ist keine gewöhnliche Datei; wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>%1: the temporary file beside it cannot be read (%2); check the disk</source>
        <translation>%1: die temporäre Datei daneben kann nicht gelesen werden (%2); prüfen Sie den Datenträger</translation>
    </message>
    <message>
        <source>%1 was left out: %2, of which it was packed, is in the folder, too</source>
        <translation>%1 wurde ausgelassen: %2, woraus es gepackt wurde, liegt auch im Ordner</translation>
    </message>
    <message>
        <source>both sides of its triangles count, and not those of %1</source>
        <translation>beide Seiten seiner Dreiecke zählen, die von %1 nicht</translation>
    </message>
    <message>
        <source>both sides of the triangles of %1 count, and not those of this one</source>
        <translation>beide Seiten der Dreiecke von %1 zählen, die dieser Datei nicht</translation>
    </message>
    <message>
        <source>let both sides count for all of them, or pack it again without that</source>
        <translation>für alle beide Seiten zählen lassen oder es ohne das erneut packen</translation>
    </message>
    <message>
        <source>the binary glTF ends before its first chunk does</source>
        <translation>die binäre glTF-Datei endet vor ihrem ersten Abschnitt</translation>
    </message>
    <message>
        <source>not all processes have begun within %1 s; run again, or run on this program alone</source>
        <translation>innerhalb von %1 s haben nicht alle Prozesse begonnen; erneut berechnen oder mit diesem Programm allein</translation>
    </message>
    <message>
        <source>%1: %2 joins vertices across cells when its distance is above 0 and cannot keep to a bound of memory; leave it out, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 fasst mit einem Abstand über 0 Ecken über Zellen hinweg zusammen und kann keine Speichergrenze einhalten; lassen Sie ihn weg, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>%1: %2 moves vertices that cells share and cannot keep to a bound of memory; leave it out, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 bewegt Ecken, die Zellen gemeinsam haben, und kann keine Speichergrenze einhalten; lassen Sie ihn weg, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>%1: %2 sees across cells and cannot keep to a bound of memory; leave it out, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 sieht über Zellen hinaus und kann keine Speichergrenze einhalten; lassen Sie ihn weg, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>Not walkable: without area</source>
        <translation>Nicht begehbar: ohne Fläche</translation>
    </message>
    <message>
        <source>The corners of this triangle lie on one line.</source>
        <translation>Die Ecken dieses Dreiecks liegen auf einer Linie.</translation>
    </message>
    <message>
        <source>Not walkable: too steep</source>
        <translation>Nicht begehbar: zu steil</translation>
    </message>
    <message>
        <source>It rises by %1; at most %2 are allowed.</source>
        <translation>Es steigt um %1; höchstens %2 sind erlaubt.</translation>
    </message>
    <message>
        <source>Too steep</source>
        <translation>Zu steil</translation>
    </message>
    <message>
        <source>Not walkable: too low</source>
        <translation>Nicht begehbar: zu niedrig</translation>
    </message>
    <message>
        <source>Triangle %3 is %1 above it; agents need %2.</source>
        <translation>Dreieck %3 liegt %1 darüber; Agenten brauchen %2.</translation>
    </message>
    <message>
        <source>Something is above it within the %2 that agents need.</source>
        <translation>Etwas liegt darüber, innerhalb der %2, die Agenten brauchen.</translation>
    </message>
    <message>
        <source>Too little headroom</source>
        <translation>Zu wenig Kopffreiheit</translation>
    </message>
    <message>
        <source>Not walkable: too near a border</source>
        <translation>Nicht begehbar: zu nah an einem Rand</translation>
    </message>
    <message>
        <source>Agents stay %2 away from borders.</source>
        <translation>Agenten bleiben %2 von Rändern weg.</translation>
    </message>
    <message>
        <source>Too near a border</source>
        <translation>Zu nah an einem Rand</translation>
    </message>
    <message>
        <source>Not walkable: too near a wall</source>
        <translation>Nicht begehbar: zu nah an einer Wand</translation>
    </message>
    <message>
        <source>Agents stay %2 away from walls; this place is %1 from the nearest one.</source>
        <translation>Agenten bleiben %2 von Wänden weg; dieser Ort ist %1 von der nächsten entfernt.</translation>
    </message>
    <message>
        <source>Agents stay %2 away from walls.</source>
        <translation>Agenten bleiben %2 von Wänden weg.</translation>
    </message>
    <message>
        <source>Too near a wall</source>
        <translation>Zu nah an einer Wand</translation>
    </message>
    <message>
        <source>Not walkable: too near a ledge</source>
        <translation>Nicht begehbar: zu nah an einer Kante</translation>
    </message>
    <message>
        <source>Agents stay %2 away from ledges: drops and the ends of the level; this place is %1 from the nearest one.</source>
        <translation>Agenten bleiben %2 von Kanten weg: Abgründen und den Enden des Levels; dieser Ort ist %1 von der nächsten entfernt.</translation>
    </message>
    <message>
        <source>Agents stay %2 away from ledges: drops and the ends of the level.</source>
        <translation>Agenten bleiben %2 von Kanten weg: Abgründen und den Enden des Levels.</translation>
    </message>
    <message>
        <source>Too near a ledge</source>
        <translation>Zu nah an einer Kante</translation>
    </message>
    <message>
        <source>Not walkable: unreachable</source>
        <translation>Nicht begehbar: unerreichbar</translation>
    </message>
    <message>
        <source>It cannot be reached from the seeds.</source>
        <translation>Es kann von den Startpunkten aus nicht erreicht werden.</translation>
    </message>
    <message>
        <source>Cannot be reached</source>
        <translation>Nicht erreichbar</translation>
    </message>
    <message>
        <source>Not walkable: too small an area</source>
        <translation>Nicht begehbar: zu kleine Fläche</translation>
    </message>
    <message>
        <source>The connected region around it has an area of %1; it must have more than %2.</source>
        <translation>Das zusammenhängende Gebiet darum hat eine Fläche von %1; es muss mehr als %2 haben.</translation>
    </message>
    <message>
        <source>Too small an area</source>
        <translation>Zu kleine Fläche</translation>
    </message>
    <message>
        <source>Not walkable: merged away</source>
        <translation>Nicht begehbar: verschmolzen</translation>
    </message>
    <message>
        <source>The filter moved vertices, and no triangle is here any more.</source>
        <translation>Der Filter hat Ecken bewegt, und hier ist kein Dreieck mehr.</translation>
    </message>
    <message>
        <source>%1: %2 stands behind an AreaFilter, which needs all cells; put it before that, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 steht hinter einem AreaFilter, der alle Zellen braucht; setzen Sie ihn davor, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>the tiles have more than %1 triangles together, which is more than one file can have; use them one by one</source>
        <translation>die Kacheln haben zusammen mehr als %1 Dreiecke, mehr als eine Datei haben kann; verwenden Sie sie einzeln</translation>
    </message>
    <message>
        <source>%1 and %2 are tiles of different environments, pipelines or slices; give folders of one run</source>
        <translation>%1 und %2 sind Kacheln verschiedener Umgebungen, Pipelines oder Teile; geben Sie Ordner eines Laufs an</translation>
    </message>
    <message>
        <source>%1 is slice %2 of %3, and the folders given are not all of them, each once; give all</source>
        <translation>%1 ist Teil %2 von %3, und die angegebenen Ordner sind nicht alle Teile, jeder einmal; geben Sie alle an</translation>
    </message>
    <message>
        <source>%1: a memory of %2 is too little; give %3 or more, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 Speicher sind zu wenig; geben Sie mindestens %3 an, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>run `footfall run --memory` again</source>
        <translation>rechnen Sie noch einmal mit `footfall run --memory`</translation>
    </message>
    <message>
        <source>is no folder of tiles</source>
        <translation>ist kein Ordner mit Kacheln</translation>
    </message>
    <message>
        <source>give the one that `footfall run --memory` wrote</source>
        <translation>geben Sie den an, den `footfall run --memory` geschrieben hat</translation>
    </message>
    <message>
        <source>has no index.json: it is no folder of tiles, or the run did not end</source>
        <translation>hat keine index.json: Es ist kein Ordner mit Kacheln, oder der Lauf kam nicht zum Ende</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>is damaged, or of another run than the index</source>
        <translation>ist beschädigt oder von einem anderen Lauf als das Verzeichnis</translation>
    </message>
    <message>
        <source>--stats %1: this file is in the folder of the tiles; choose another place</source>
        <translation>--stats %1: Die Datei liegt im Ordner der Kacheln; einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>%1: more than %2 triangles lie above one place; use footfall run --memory</source>
        <translation>%1: Über einer Stelle liegen mehr als %2 Dreiecke; verwenden Sie footfall run --memory</translation>
    </message>
    <message>
        <source>%1: there are no triangles at that place; choose another one</source>
        <translation>%1: An dieser Stelle sind keine Dreiecke; wählen Sie eine andere</translation>
    </message>
    <message>
        <source>%1: a second %2 cannot keep to a bound of memory; leave it out, or run without the bound, with all of the environment in memory</source>
        <translation>%1: ein zweiter %2 kann keine Speichergrenze einhalten; lassen Sie ihn weg, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>%1: %2 stands behind a StepFilter, which needs what it leaves; put it before that, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 steht hinter einem StepFilter, der braucht, was er übrig lässt; setzen Sie ihn davor, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>StepFilter with a gap sees over the borders of slices; give it a gap of 0, or run all slices at once</source>
        <translation>StepFilter mit einer Lücke sieht über die Grenzen von Teilen hinaus; geben Sie ihm eine Lücke von 0, oder rechnen Sie alle Teile auf einmal</translation>
    </message>
    <message>
        <source>%1: %2 stands behind a filter that needs all cells; put it before that, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 steht hinter einem Filter, der alle Zellen braucht; setzen Sie ihn davor, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>%1: %2 keeps to a bound of memory exactly only, not approximately; leave that out, or run without the bound, with all of the environment in memory</source>
        <translation>%1: %2 kann nur in der genauen Form eine Speichergrenze einhalten, nicht in der ungefähren; lassen Sie diese weg, oder rechnen Sie ohne die Grenze, mit der ganzen Umgebung im Speicher</translation>
    </message>
    <message>
        <source>the walkable area has more triangles than LayerSubdivisionFilter can number; leave it out</source>
        <translation>die begehbare Fläche hat mehr Dreiecke, als LayerSubdivisionFilter nummerieren kann; lassen Sie ihn weg</translation>
    </message>
    <message>
        <source>%1 sees over the borders of slices; leave it out, or run all slices at once</source>
        <translation>%1 sieht über die Grenzen von Teilen hinaus; lassen Sie ihn weg, oder rechnen Sie alle Teile auf einmal</translation>
    </message>
    <message>
        <source>%1: cannot be renamed: %2; check which other program writes into the folder, and run again</source>
        <translation>%1: lässt sich nicht umbenennen: %2; prüfen Sie, welches andere Programm in den Ordner schreibt, und rechnen Sie noch einmal</translation>
    </message>
    <message>
        <source>%1: has a run that did not end, of another environment, other filters or another bound; remove the folder, or give a new name</source>
        <translation>%1: enthält einen Lauf, der nicht zu Ende ging, mit einer anderen Umgebung, anderen Filtern oder einer anderen Grenze; entfernen Sie den Ordner, oder geben Sie einen neuen Namen an</translation>
    </message>
    <message>
        <source>no other program can be started: too many files are open; close some, or raise the limit (ulimit -n)</source>
        <translation>es kann kein anderes Programm gestartet werden: zu viele Dateien sind offen; einige schließen oder die Grenze anheben (ulimit -n)</translation>
    </message>
    <message>
        <source>no other program can be started: there are too many processes, or too little memory is left; close other programs</source>
        <translation>es kann kein anderes Programm gestartet werden: es gibt zu viele Prozesse, oder zu wenig Speicher ist frei; andere Programme schließen</translation>
    </message>
    <message>
        <source>no more threads can be started; close other programs, raise the limit (ulimit -u), or give fewer threads (--threads)</source>
        <translation>es können keine weiteren Threads gestartet werden; andere Programme schließen, die Grenze anheben (ulimit -u) oder weniger Threads angeben (--threads)</translation>
    </message>
    <message>
        <source>too many files are open; close other programs, or raise the limit (ulimit -n)</source>
        <translation>zu viele Dateien sind offen; andere Programme schließen oder die Grenze anheben (ulimit -n)</translation>
    </message>
    <message>
        <source>the disk is full; free some space</source>
        <translation>der Datenträger ist voll; Platz schaffen</translation>
    </message>
    <message>
        <source>%1 is read by the program footfall-import, and FOOTFALL_IMPORT names &apos;%2&apos;, which is none</source>
        <translation>%1 wird vom Programm footfall-import gelesen, und FOOTFALL_IMPORT nennt „%2“, das keines ist</translation>
    </message>
    <message>
        <source>%1 is read by the program footfall-import, which is missing beside Footfall</source>
        <translation>%1 wird vom Programm footfall-import gelesen, das neben Footfall fehlt</translation>
    </message>
    <message>
        <source>install Footfall again, name the program in the environment variable FOOTFALL_IMPORT, or convert the file to OBJ</source>
        <translation>Footfall neu installieren, das Programm in der Umgebungsvariable FOOTFALL_IMPORT nennen oder die Datei in OBJ umwandeln</translation>
    </message>
    <message>
        <source>footfall-import, which reads %1, cannot be started (%2)</source>
        <translation>footfall-import, das %1 liest, kann nicht gestartet werden (%2)</translation>
    </message>
    <message>
        <source>install Footfall again</source>
        <translation>Footfall neu installieren</translation>
    </message>
    <message>
        <source>the file is damaged, or that reader is: export it again, or as OBJ</source>
        <translation>die Datei ist beschädigt, oder dieser Leser ist es: neu exportieren oder als OBJ</translation>
    </message>
    <message>
        <source>the reader for %1 ended by signal %2</source>
        <translation>der Leser für %1 wurde durch Signal %2 beendet</translation>
    </message>
    <message>
        <source>the reader for %1 ended with exit status %2</source>
        <translation>der Leser für %1 endete mit dem Status %2</translation>
    </message>
    <message>
        <source>export it again, or as OBJ; if the file is valid, switch the limits off (--no-import-limits)</source>
        <translation>neu exportieren oder als OBJ; wenn die Datei gültig ist, die Grenzen ausschalten (--no-import-limits)</translation>
    </message>
    <message>
        <source>reading it as %1 took more than %2 seconds, far more than files of its size need</source>
        <translation>sie als %1 zu lesen dauerte mehr als %2 Sekunden, weit mehr als Dateien ihrer Größe brauchen</translation>
    </message>
    <message>
        <source>reading it as %1 took more than %2 MB of memory, far more than files of its size need</source>
        <translation>sie als %1 zu lesen brauchte mehr als %2 MB Speicher, weit mehr als Dateien ihrer Größe brauchen</translation>
    </message>
    <message>
        <source>the reader for %1 ended too early</source>
        <translation>der Leser für %1 ist vorzeitig zu Ende gegangen</translation>
    </message>
    <message>
        <source>install Footfall again; where that does not help, convert the file to OBJ</source>
        <translation>Footfall neu installieren; wenn das nicht hilft, die Datei in OBJ umwandeln</translation>
    </message>
    <message>
        <source>was closed by its reader before all was written</source>
        <translation>wurde vom Leser geschlossen, bevor alles geschrieben war</translation>
    </message>
    <message>
        <source>check why it ended, and run this again</source>
        <translation>nachsehen, warum er endete, und dies wiederholen</translation>
    </message>
    <message>
        <source>cannot be written: too many files are open</source>
        <translation>kann nicht geschrieben werden: zu viele Dateien sind offen</translation>
    </message>
    <message>
        <source>close other programs, or raise the limit (ulimit -n)</source>
        <translation>andere Programme schließen oder die Grenze anheben (ulimit -n)</translation>
    </message>
    <message>
        <source>a mesh has the unknown mode %1</source>
        <translation>ein Netz hat den unbekannten Modus %1</translation>
    </message>
    <message>
        <source>a primitive of a mesh is not an object</source>
        <translation>ein Teil eines Netzes ist kein Objekt</translation>
    </message>
    <message>
        <source>The file needs the glTF extension %1, which is not read: something may be missing</source>
        <translation>Die Datei braucht die glTF-Erweiterung %1, die nicht gelesen wird: etwas kann fehlen</translation>
    </message>
    <message>
        <source>the instances of a mesh are invalid</source>
        <translation>die Instanzen eines Netzes sind ungültig</translation>
    </message>
    <message>
        <source>positions do not have three numbers each</source>
        <translation>Positionen haben nicht je drei Zahlen</translation>
    </message>
    <message>
        <source>the weights of a skin are invalid</source>
        <translation>die Gewichte einer Haut sind ungültig</translation>
    </message>
    <message>
        <source>a morph target is invalid</source>
        <translation>ein Morph-Ziel ist ungültig</translation>
    </message>
    <message>
        <source>a skin is invalid</source>
        <translation>eine Haut ist ungültig</translation>
    </message>
    <message>
        <source>a skin refers to a node that does not exist</source>
        <translation>eine Haut nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>the data packed by %1 is invalid</source>
        <translation>die mit %1 gepackten Daten sind ungültig</translation>
    </message>
    <message>
        <source>it is packed by %1, which this build of Footfall does not read</source>
        <translation>sie ist mit %1 gepackt, was dieses Footfall nicht lesen kann</translation>
    </message>
    <message>
        <source>it ends before the numbers that it announces</source>
        <translation>sie endet vor den Zahlen, die sie ankündigt</translation>
    </message>
    <message>
        <source>an accessor has the unknown type &apos;%1&apos;</source>
        <translation>ein Accessor hat den unbekannten Typ „%1“</translation>
    </message>
    <message>
        <source>an accessor has the unknown component type %1</source>
        <translation>ein Accessor hat den unbekannten Komponententyp %1</translation>
    </message>
    <message>
        <source>an accessor is out of range of its buffer</source>
        <translation>ein Accessor liegt außerhalb seines Puffers</translation>
    </message>
    <message>
        <source>it is binary glTF of another version than 2</source>
        <translation>sie ist binäres glTF einer anderen Version als 2</translation>
    </message>
    <message>
        <source>it is not JSON, or is truncated</source>
        <translation>sie ist kein JSON oder wurde abgeschnitten</translation>
    </message>
    <message>
        <source>buffer %1 has no content</source>
        <translation>Puffer %1 hat keinen Inhalt</translation>
    </message>
    <message>
        <source>buffer %1 is packed in a way that is not known</source>
        <translation>Puffer %1 ist auf unbekannte Weise gepackt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an object</source>
        <translation>„%1“ ist kein Objekt</translation>
    </message>
    <message>
        <source>a sparse accessor is out of range</source>
        <translation>ein spärlicher Accessor liegt außerhalb</translation>
    </message>
    <message>
        <source>a list of corners does not have single numbers</source>
        <translation>eine Liste von Ecken hat keine einzelnen Zahlen</translation>
    </message>
    <message>
        <source>a list of corners has numbers that are no indices</source>
        <translation>eine Liste von Ecken hat Zahlen, die keine Indizes sind</translation>
    </message>
    <message>
        <source>the transform of a node is invalid</source>
        <translation>die Transformation eines Knotens ist ungültig</translation>
    </message>
    <message>
        <source>a node refers to a child that does not exist</source>
        <translation>ein Knoten nennt ein Kind, das es nicht gibt</translation>
    </message>
    <message>
        <source>node %1 is the child of more than one node</source>
        <translation>Knoten %1 ist das Kind von mehr als einem Knoten</translation>
    </message>
    <message>
        <source>the scene refers to a node that does not exist</source>
        <translation>die Szene nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>node %1 appears twice in the scene</source>
        <translation>Knoten %1 kommt in der Szene zweimal vor</translation>
    </message>
    <message>
        <source>number %1 of its %2 is not there</source>
        <translation>Nummer %1 von %2 gibt es darin nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number that can stand there</source>
        <translation>„%1“ ist keine Zahl, die dort stehen kann</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a list</source>
        <translation>„%1“ ist keine Liste</translation>
    </message>
    <message>
        <source>a node is not an object</source>
        <translation>ein Knoten ist kein Objekt</translation>
    </message>
    <message>
        <source>%1: its reader asked for more memory than there is; check that the file is complete and in order, or close other programs</source>
        <translation>%1: ihr Leser verlangte mehr Speicher, als es gibt; prüfen, ob die Datei vollständig und in Ordnung ist, oder andere Programme schließen</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2); check that the file is complete and of the format that its extension says</source>
        <translation>%1: kann nicht gelesen werden (%2); prüfen, ob die Datei vollständig und von dem Format ist, das ihre Endung nennt</translation>
    </message>
    <message>
        <source>%1 (%2 more could not be verified)</source>
        <translation>%1 (%2 weitere ließen sich nicht nachweisen)</translation>
    </message>
    <message>
        <source>digits beyond the seventh</source>
        <translation>Stellen nach der siebten</translation>
    </message>
    <message>
        <source>digits beyond the seventh; more than 58 layers; placed obstacles</source>
        <translation>Stellen nach der siebten; mehr als 58 Ebenen; gesetzte Hindernisse</translation>
    </message>
    <message>
        <source>digits beyond the seventh, drops, layers, placed obstacles; what is smaller than a cell of Godot&apos;s map</source>
        <translation>Stellen nach der siebten, Sprünge, Ebenen, gesetzte Hindernisse; was kleiner ist als eine Zelle von Godots Karte</translation>
    </message>
    <message>
        <source>%1 needs %2 before it</source>
        <translation>%1 braucht davor: %2</translation>
    </message>
    <message>
        <source>%1 with a distance of its own to ledges needs %2 before it</source>
        <translation>%1 mit eigenem Abstand zu Kanten braucht davor: %2</translation>
    </message>
    <message>
        <source>%1: this file is in the folder of the tiles; move it, or choose another folder for the tiles</source>
        <translation>%1: Die Datei liegt im Ordner der Kacheln; sie verschieben oder für die Kacheln einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>memory ran out; close other programs or use a smaller environment</source>
        <translation>der Speicher ist ausgegangen; schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
    <message>
        <source>nothing is walkable, so there is no place to choose; check that the area is not 0</source>
        <translation>nichts ist begehbar, also kann kein Ort gewählt werden; prüfen Sie, dass die Fläche nicht 0 ist</translation>
    </message>
    <message>
        <source>the walkable area is too large for random places; use a larger unit</source>
        <translation>die begehbare Fläche ist zu groß für zufällige Orte; nehmen Sie eine größere Einheit</translation>
    </message>
    <message>
        <source>the mesh has no layers; end the pipeline with a layer filter</source>
        <translation>das Netz hat keine Ebenen; beenden Sie die Pipeline mit einem Ebenenfilter</translation>
    </message>
    <message>
        <source>there is no layer %1; give a number from 0 to %2</source>
        <translation>es gibt keine Ebene %1; geben Sie eine Zahl von 0 bis %2 an</translation>
    </message>
    <message>
        <source>docs/how-to/buildings.md says how to install it</source>
        <translation>wie man ihn installiert, steht in docs/how-to/buildings.md</translation>
    </message>
    <message>
        <source>the corridor map is too large for glTF, which ends at 4 GB; write it as .json</source>
        <translation>die Korridorkarte ist zu groß für glTF, das bei 4 GB endet; schreiben Sie sie als .json</translation>
    </message>
    <message>
        <source>about %1 vertices lie within %2 m of others without meeting them, as roundings leave them, and runs take several times longer; put the coordinates on a grid when the file is read</source>
        <translation>etwa %1 Eckpunkte liegen innerhalb von %2 m neben anderen, ohne sie zu treffen, wie Rundungen sie hinterlassen, und Läufe dauern um ein Mehrfaches länger; legen Sie die Koordinaten beim Lesen der Datei auf ein Raster</translation>
    </message>
</context>
<context>
    <name>Filter</name>
    <message>
        <source>Duplication</source>
        <translation>Doppelte Ecken</translation>
    </message>
    <message>
        <source>Merges vertices that lie close together, so that triangles that only look connected share their corners. A distance of 0 joins vertices at equal positions and moves nothing. A larger distance moves vertices and may make triangles degenerate: let a DegeneracyFilter follow.</source>
        <translation>Vereint Ecken, die nah beieinander liegen, damit Dreiecke, die nur verbunden aussehen, ihre Ecken teilen. Ein Abstand von 0 verbindet Ecken an gleicher Stelle und bewegt nichts. Ein größerer Abstand bewegt Ecken und kann Dreiecke entarten lassen: Lassen Sie einen DegeneracyFilter folgen.</translation>
    </message>
    <message>
        <source>No two separate vertices are closer to each other than the distance. The result does not depend on the order of the vertices in the file.</source>
        <translation>Keine zwei getrennten Ecken liegen näher beieinander als der Abstand. Das Ergebnis hängt nicht von der Reihenfolge der Ecken in der Datei ab.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Vertices closer than this become one; 0 joins equal positions only.</source>
        <translation>Ecken, die näher liegen, werden eine; 0 verbindet nur gleiche Stellen.</translation>
    </message>
    <message>
        <source>Degeneracy</source>
        <translation>Entartung</translation>
    </message>
    <message>
        <source>Removes triangles without area: those with a repeated corner and those whose corners lie on one line. An obstacle edge of a removed triangle moves to the neighbour that shares it.</source>
        <translation>Entfernt Dreiecke ohne Fläche: die mit einer wiederholten Ecke und die, deren Ecken auf einer Linie liegen. Eine Hinderniskante eines entfernten Dreiecks geht auf den Nachbarn über, der sie teilt.</translation>
    </message>
    <message>
        <source>No triangle of the environment, walkable or rejected, is degenerate.</source>
        <translation>Kein Dreieck der Umgebung, ob begehbar oder verworfen, ist entartet.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Keeps what is not too steep to walk on. The comparison is exact: a triangle stays walkable when its slope is at most the maximum plus the tolerance. Triangles that face down are never walkable. What is removed stays an obstacle.</source>
        <translation>Behält, was zum Gehen nicht zu steil ist. Der Vergleich ist exakt: Ein Dreieck bleibt begehbar, wenn seine Neigung höchstens die größte Neigung und die Toleranz ist. Dreiecke, die nach unten zeigen, sind nie begehbar. Was entfernt wird, bleibt ein Hindernis.</translation>
    </message>
    <message>
        <source>Every walkable triangle faces up and is inclined by at most the maximum slope and its tolerance.</source>
        <translation>Jedes begehbare Dreieck zeigt nach oben und ist höchstens um die größte Neigung und ihre Toleranz geneigt.</translation>
    </message>
    <message>
        <source>Maximum slope</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>The steepest ground that an agent can walk on, measured from the horizontal.</source>
        <translation>Der steilste Boden, auf dem ein Agent gehen kann, gegen die Waagerechte gemessen.</translation>
    </message>
    <message>
        <source>How much steeper ground may be: rounding makes some ramps of exactly the maximum slope a little steeper. 0: not at all.</source>
        <translation>Wie viel steiler der Boden sein darf: Durch Rundung werden manche Rampen mit genau der größten Neigung ein wenig steiler. 0: gar nicht.</translation>
    </message>
    <message>
        <source>Vertical clearance</source>
        <translation>Durchgangshöhe</translation>
    </message>
    <message>
        <source>Removes the places where an agent would hit its head: those with anything, walkable or not, straight above and lower than the clearance. A vertical wall covers no area, so it removes none; where it reaches into the clearance it leaves obstacle edges, which agents cannot cross. Where walkable triangles overlap in one plane, one of them stays.</source>
        <translation>Entfernt die Stellen, an denen sich ein Agent den Kopf stieße: die, über denen etwas, ob begehbar oder nicht, senkrecht darüber und niedriger als die Durchgangshöhe liegt. Eine senkrechte Wand bedeckt keine Fläche und entfernt daher keine; wo sie in die Durchgangshöhe ragt, hinterlässt sie Hinderniskanten, die Agenten nicht überqueren können. Wo begehbare Dreiecke in einer Ebene überlappen, bleibt eines.</translation>
    </message>
    <message>
        <source>No walkable point has a point of another triangle straight above it and nearer than the clearance; no place is walkable twice.</source>
        <translation>Kein begehbarer Punkt hat einen Punkt eines anderen Dreiecks senkrecht über sich, der näher ist als die Durchgangshöhe; keine Stelle ist zweimal begehbar.</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Durchgangshöhe</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Removes regions that are too small to matter, such as table tops and ledges. A region is what can be reached over shared edges without crossing an obstacle edge. What is removed stays an obstacle.</source>
        <translation>Entfernt Gebiete, die zu klein sind, um zu zählen, etwa Tischplatten und Simse. Ein Gebiet ist, was über gemeinsame Kanten zu erreichen ist, ohne eine Hinderniskante zu überqueren. Was entfernt wird, bleibt ein Hindernis.</translation>
    </message>
    <message>
        <source>Every walkable region has a surface area above the minimum.</source>
        <translation>Jedes begehbare Gebiet hat eine Oberfläche über der kleinsten.</translation>
    </message>
    <message>
        <source>Minimum area</source>
        <translation>Kleinste Fläche</translation>
    </message>
    <message>
        <source>Regions of at most this surface area are removed; 0 removes nothing.</source>
        <translation>Gebiete mit höchstens dieser Oberfläche werden entfernt; 0 entfernt nichts.</translation>
    </message>
    <message>
        <source>Simplification</source>
        <translation>Vereinfachung</translation>
    </message>
    <message>
        <source>Covers each flat region with as few triangles as its outline needs. Outlines, holes and obstacle edges stay as they are. The approximate form also joins regions that are nearly coplanar.</source>
        <translation>Bedeckt jedes ebene Gebiet mit so wenigen Dreiecken, wie sein Umriss braucht. Umrisse, Löcher und Hinderniskanten bleiben, wie sie sind. Die genäherte Form vereint auch Gebiete, die fast in einer Ebene liegen.</translation>
    </message>
    <message>
        <source>No walkable triangle is degenerate.</source>
        <translation>Kein begehbares Dreieck ist entartet.</translation>
    </message>
    <message>
        <source>Other triangles, the same walkable area. In the approximate form vertices may move, by a stated bound at most.</source>
        <translation>Andere Dreiecke, dieselbe begehbare Fläche. In der genäherten Form können sich Ecken bewegen, höchstens um eine angegebene Schranke.</translation>
    </message>
    <message>
        <source>Approximate</source>
        <translation>Genähert</translation>
    </message>
    <message>
        <source>Treat nearly coplanar neighbours as coplanar.</source>
        <translation>Nachbarn, die fast in einer Ebene liegen, so behandeln, als lägen sie darin.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>In the approximate form, triangles count as coplanar when the dot product of their unit normals is above 1 minus this.</source>
        <translation>In der genäherten Form gelten Dreiecke als in einer Ebene, wenn das Skalarprodukt ihrer Einheitsnormalen über 1 minus diesem Wert liegt.</translation>
    </message>
    <message>
        <source>Layer subdivision</source>
        <translation>Aufteilung in Ebenen</translation>
    </message>
    <message>
        <source>Splits the walkable area into layers, such as the floors of a building, so that each can be drawn as a flat map. Edges on which two layers meet become connections; the fewer, the better.</source>
        <translation>Teilt die begehbare Fläche in Ebenen, etwa die Stockwerke eines Gebäudes, damit jede als flache Karte gezeichnet werden kann. Kanten, an denen sich zwei Ebenen treffen, werden Verbindungen; je weniger, desto besser.</translation>
    </message>
    <message>
        <source>Every walkable triangle has an area and is not vertical.</source>
        <translation>Jedes begehbare Dreieck hat eine Fläche und ist nicht senkrecht.</translation>
    </message>
    <message>
        <source>No two triangles of one layer overlap in the plan; layers and connections form a multi-layered environment.</source>
        <translation>Keine zwei Dreiecke einer Ebene überlappen im Grundriss; Ebenen und Verbindungen bilden eine mehrschichtige Umgebung.</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Gives every vertex double coordinates and repairs what rounding can break: corners that fall together, triangles that lose their area or turn over. Reports the number of each case.</source>
        <translation>Gibt jeder Ecke Koordinaten doppelter Genauigkeit und repariert, was Runden zerstören kann: Ecken, die zusammenfallen, Dreiecke, die ihre Fläche verlieren oder umklappen. Meldet die Zahl jedes Falls.</translation>
    </message>
    <message>
        <source>Every vertex has double coordinates and no walkable triangle is degenerate or turned over.</source>
        <translation>Jede Ecke hat Koordinaten doppelter Genauigkeit, und kein begehbares Dreieck ist entartet oder umgeklappt.</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>The thesis&apos;s files give this value. Rounding is always repaired here, so both values give the same result.</source>
        <translation>Die Dateien der Dissertation geben diesen Wert an. Gerundetes wird hier immer repariert, daher ergeben beide Werte dasselbe.</translation>
    </message>
    <message>
        <source>Grid strategy</source>
        <translation>Gitterstrategie</translation>
    </message>
    <message>
        <source>Cuts the environment into a grid of equal rectangles in the plan and begins a parallel block. Good where obstacles are spread evenly.</source>
        <translation>Schneidet die Umgebung im Grundriss in ein Gitter gleicher Rechtecke und beginnt einen parallelen Block. Gut, wo Hindernisse gleichmäßig verteilt sind.</translation>
    </message>
    <message>
        <source>A Collapse follows, with only local filters in between.</source>
        <translation>Ein Collapse folgt, mit nur lokalen Filtern dazwischen.</translation>
    </message>
    <message>
        <source>The filters up to Collapse run on each cell on its own.</source>
        <translation>Die Filter bis zum Collapse laufen auf jeder Zelle für sich.</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Number of cells along x.</source>
        <translation>Anzahl der Zellen entlang x.</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Number of cells along y.</source>
        <translation>Anzahl der Zellen entlang y.</translation>
    </message>
    <message>
        <source>Recursive strategy</source>
        <translation>Rekursive Strategie</translation>
    </message>
    <message>
        <source>Cuts the environment into four equal rectangles, and each of them again as long as it holds many triangles, and begins a parallel block.</source>
        <translation>Schneidet die Umgebung in vier gleiche Rechtecke, und jedes davon wieder, solange es viele Dreiecke enthält, und beginnt einen parallelen Block.</translation>
    </message>
    <message>
        <source>Fewest triangles</source>
        <translation>Wenigste Dreiecke</translation>
    </message>
    <message>
        <source>A cell with no more triangles than this is not cut again.</source>
        <translation>Eine Zelle mit nicht mehr Dreiecken als diesen wird nicht weiter geschnitten.</translation>
    </message>
    <message>
        <source>Largest depth</source>
        <translation>Größte Tiefe</translation>
    </message>
    <message>
        <source>The largest number of cuts inside each other.</source>
        <translation>Die größte Zahl von Schnitten ineinander.</translation>
    </message>
    <message>
        <source>Round the cuts</source>
        <translation>Schnitte runden</translation>
    </message>
    <message>
        <source>Read from the thesis&apos;s files, where points on cuts are rounded to keep numbers small. Here no obstacle is cut and cuts vanish in Collapse, so both values give the same result; only the cut environment of footfall cells -o differs.</source>
        <translation>Wird aus den Dateien der Dissertation gelesen, in der Punkte auf Schnitten gerundet werden, damit Zahlen klein bleiben. Hier wird kein Hindernis zerschnitten, und Schnitte verschwinden im Collapse, daher ergeben beide Werte dasselbe; nur die zerschnittene Umgebung von footfall cells -o ist eine andere.</translation>
    </message>
    <message>
        <source>Sorted recursive strategy</source>
        <translation>Sortierte rekursive Strategie</translation>
    </message>
    <message>
        <source>Cuts the environment into halves of about equally many triangles, across x and y in turn and again as long as a part holds many, and begins a parallel block.</source>
        <translation>Schneidet die Umgebung in Hälften mit etwa gleich vielen Dreiecken, abwechselnd quer zu x und y und weiter, solange ein Teil viele enthält, und beginnt einen parallelen Block.</translation>
    </message>
    <message>
        <source>Height-aware strategy</source>
        <translation>Höhenbewusste Strategie</translation>
    </message>
    <message>
        <source>Divides the floors, across the plan and between storeys, into cells of about equal work, each with only the obstacles that can stand in the clearance above its floors, and begins a parallel block. Good for towers and buildings with storeys.</source>
        <translation>Teilt die Böden, im Grundriss und zwischen Stockwerken, in Zellen mit etwa gleich viel Arbeit, jede nur mit den Hindernissen, die in der Durchgangshöhe über ihren Böden stehen können, und beginnt einen parallelen Block. Gut für Türme und Gebäude mit Stockwerken.</translation>
    </message>
    <message>
        <source>Least work</source>
        <translation>Wenigste Arbeit</translation>
    </message>
    <message>
        <source>A cell with no more estimated work than this is not cut again. The unit is one triangle that nothing stands on.</source>
        <translation>Eine Zelle mit nicht mehr geschätzter Arbeit als dieser wird nicht weiter geschnitten. Die Einheit ist ein Dreieck, auf dem nichts steht.</translation>
    </message>
    <message>
        <source>Automatic strategy</source>
        <translation>Automatische Strategie</translation>
    </message>
    <message>
        <source>Picks a strategy and its depth from the environment and the number of threads, says what it picked and why, and begins a parallel block. Small environments stay in one cell.</source>
        <translation>Wählt eine Strategie und ihre Tiefe nach der Umgebung und der Zahl der Threads, sagt, was sie gewählt hat und warum, und beginnt einen parallelen Block. Kleine Umgebungen bleiben in einer Zelle.</translation>
    </message>
    <message>
        <source>Collapse</source>
        <translation>Zusammenfügen</translation>
    </message>
    <message>
        <source>Ends a parallel block: puts the cells together again. The seams vanish, so that the result is the one of the same filters without a block.</source>
        <translation>Beendet einen parallelen Block: fügt die Zellen wieder zusammen. Die Nähte verschwinden, sodass das Ergebnis das derselben Filter ohne Block ist.</translation>
    </message>
    <message>
        <source>A strategy stands before it.</source>
        <translation>Eine Strategie steht davor.</translation>
    </message>
    <message>
        <source>One environment again, without a trace of the cells.</source>
        <translation>Wieder eine Umgebung, ohne eine Spur der Zellen.</translation>
    </message>
    <message>
        <source>The free height that an agent needs. An obstacle at exactly this height is no obstacle; where coordinates lie on a grid, one that is lower by a step of the grid is none either. Less than about 1e-29 of the largest coordinate is refused.</source>
        <translation>Die freie Höhe, die ein Agent braucht. Ein Hindernis in genau dieser Höhe ist keines; wo Koordinaten auf einem Raster liegen, ist auch eines keines, das um einen Schritt des Rasters tiefer liegt. Weniger als etwa 1e-29 der größten Koordinate wird abgelehnt.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>The highest step that an agent climbs, this height included. Where coordinates lie on a grid, a step that is higher by one step of the grid is climbed as well.</source>
        <translation>Die höchste Stufe, die ein Agent steigt, diese Höhe eingeschlossen. Wo Koordinaten auf einem Raster liegen, wird auch eine Stufe gestiegen, die um einen Schritt des Rasters höher ist.</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 2</source>
        <translation>Dissertation 3.2, Filter 2</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 1; cases 2 to 4 and algorithm 3 of 4.4.2</source>
        <translation>Dissertation 3.2, Filter 1; Fälle 2 bis 4 und Algorithmus 3 von 4.4.2</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 3</source>
        <translation>Dissertation 3.2, Filter 3</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 4; obstacle edges of walls: ours</source>
        <translation>Dissertation 3.2, Filter 4; Hinderniskanten von Wänden: eigenes Verfahren</translation>
    </message>
    <message>
        <source>ours</source>
        <translation>eigenes Verfahren</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>Erreichbar</translation>
    </message>
    <message>
        <source>Each seed has a walkable place under it.</source>
        <translation>Unter jedem Startpunkt liegt eine begehbare Stelle.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>The first coordinate of a seed, as in the environment&apos;s file.</source>
        <translation>Die erste Koordinate eines Startpunkts, wie in der Datei der Umgebung.</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>The second coordinate of a seed, as in the environment&apos;s file.</source>
        <translation>Die zweite Koordinate eines Startpunkts, wie in der Datei der Umgebung.</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>The third coordinate of a seed, as in the environment&apos;s file.</source>
        <translation>Die dritte Koordinate eines Startpunkts, wie in der Datei der Umgebung.</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 5</source>
        <translation>Dissertation 3.2, Filter 5</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 6; approximate form: 5.1.2, tolerance: listing of 5.4</source>
        <translation>Dissertation 3.2, Filter 6; näherungsweise Form: 5.1.2, Toleranz: Listing in 5.4</translation>
    </message>
    <message>
        <source>thesis 3.2, filter 7; Hillebrand et al. 2016</source>
        <translation>Dissertation 3.2, Filter 7; Hillebrand et al. 2016</translation>
    </message>
    <message>
        <source>thesis 5.1.1; 4.4.2, cases 1 to 5</source>
        <translation>Dissertation 5.1.1; 4.4.2, Fälle 1 bis 5</translation>
    </message>
    <message>
        <source>thesis 4.3.1</source>
        <translation>Dissertation 4.3.1</translation>
    </message>
    <message>
        <source>thesis 4.3.2</source>
        <translation>Dissertation 4.3.2</translation>
    </message>
    <message>
        <source>thesis 4.3.3</source>
        <translation>Dissertation 4.3.3</translation>
    </message>
    <message>
        <source>ours; thesis 6.1, first proposal</source>
        <translation>eigenes Verfahren; Dissertation 6.1, erster Vorschlag</translation>
    </message>
    <message>
        <source>thesis 4.1, 5.4</source>
        <translation>Dissertation 4.1, 5.4</translation>
    </message>
    <message>
        <source>Links borders of the walkable area that lie over each other in the plan, or beside each other with a gap between them, where an agent can lift its feet from one to the other: stairs, kerbs, thresholds, low walls without thickness, slits. The area stays as it is; for the filters that follow, what is linked is one region.</source>
        <translation>Verbindet Ränder der begehbaren Fläche, die im Grundriss übereinander oder mit einer Lücke dazwischen nebeneinander liegen, wo ein Agent die Füße von einem zum anderen heben kann: Treppen, Bordsteine, Schwellen, niedrige Wände ohne Dicke, Spalten. Die Fläche bleibt, wie sie ist; für die folgenden Filter ist das Verbundene ein Gebiet.</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>The widest gap that an agent steps over, seen from above. 0: borders must coincide.</source>
        <translation>Die breiteste Lücke, über die ein Agent tritt, von oben gesehen. 0: Ränder müssen zusammenfallen.</translation>
    </message>
    <message>
        <source>No walkable place is nearer to a wall than the radius, or to a ledge than its own distance, and none that is farther than that by more than the tolerance is removed. Straight borders move by the distance, rounded outwards; round corners are polygons.</source>
        <translation>Kein begehbarer Ort ist näher an einer Wand als der Radius oder an einer Kante als deren eigener Abstand, und keiner, der um mehr als die Toleranz weiter weg ist, fällt weg. Gerade Ränder rücken um den Abstand, nach außen gerundet; runde Ecken sind Vielecke.</translation>
    </message>
    <message>
        <source>The distance that an agent&apos;s middle keeps from walls: borders with an obstacle that is higher than a step and not above its head. 0: no distance from walls.</source>
        <translation>Der Abstand, den die Mitte eines Agenten von Wänden hält: Rändern mit einem Hindernis, das höher als eine Stufe ist und nicht über seinem Kopf liegt. 0: kein Abstand von Wänden.</translation>
    </message>
    <message>
        <source>From ledges</source>
        <translation>Von Kanten</translation>
    </message>
    <message>
        <source>The distance that it keeps from all other borders: drops and the ends of the level. A distance other than the radius needs a VerticalClearanceFilter before it. 0: no distance from ledges.</source>
        <translation>Der Abstand, den sie von allen anderen Rändern hält: Abgründen und den Enden des Levels. Ein anderer Abstand als der Radius braucht einen VerticalClearanceFilter davor. 0: kein Abstand von Kanten.</translation>
    </message>
    <message>
        <source>The share of the distances by which more may be removed at round corners. Smaller values give rounder corners and more triangles.</source>
        <translation>Der Anteil der Abstände, um den an runden Ecken mehr wegfallen darf. Kleinere Werte geben rundere Ecken und mehr Dreiecke.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Finds where an agent can drop from a ledge of the walkable area to a lower place, one way: straight below the ledge, or where the first floor begins within the reach outwards. Nothing may stand in the way, higher than the step of the StepFilter before it and within the clearance, or above the landing along the fall. The area stays as it is.</source>
        <translation>Findet, wo ein Agent von einer Kante der begehbaren Fläche auf eine tiefere Stelle hinabspringen kann, nur in dieser Richtung: senkrecht unter der Kante oder dort, wo in der Reichweite nach außen ein Boden beginnt. Nichts darf im Weg stehen, was höher als die Stufe des StepFilters davor ist und in die Durchgangshöhe reicht, und nichts über der Landestelle entlang des Falls. Die Fläche bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>A VerticalClearanceFilter comes before it; only AreaFilter, ReachableFilter and DropFilter follow.</source>
        <translation>Davor steht ein VerticalClearanceFilter; es folgen nur AreaFilter, ReachableFilter und DropFilter.</translation>
    </message>
    <message>
        <source>Every drop that is found is free. Those that land straight below are all found, but for rounding of their ends; of those across a gap, all that have a little to spare.</source>
        <translation>Jeder gefundene Sprung ist frei. Die senkrecht nach unten werden bis auf Rundung ihrer Enden alle gefunden; von denen über einen Spalt alle, die ein wenig Spielraum haben.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>The deepest drop that an agent takes, this depth included.</source>
        <translation>Der tiefste Sprung, den ein Agent macht, diese Tiefe eingeschlossen.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>The largest distance outwards, seen from above, at which an agent lands. After a RadiusFilter, give at least twice its radius.</source>
        <translation>Der größte Abstand nach außen, von oben gesehen, in dem ein Agent landet. Nach einem RadiusFilter geben Sie mindestens das Doppelte seines Radius an.</translation>
    </message>
    <message>
        <source>Keeps what can be reached from given places, the seeds. Ways lead over shared edges and steps, and down over drops; roofs, islands and the insides of solids go. Put it behind a StepFilter and a DropFilter, where there is one. A seed means the highest walkable place at or under it, at most the clearance lower; before any VerticalClearanceFilter, however much lower. On an edge or a corner it means all that meets there. What is removed stays an obstacle.</source>
        <translation>Behält, was von gegebenen Stellen, den Startpunkten, aus erreicht werden kann. Wege führen über gemeinsame Kanten und Stufen und über Sprünge hinab; Dächer, Inseln und das Innere von Körpern entfallen. Gehört hinter einen StepFilter und einen DropFilter, wo es einen gibt. Ein Startpunkt meint die höchste begehbare Stelle an oder unter ihm, höchstens um die Durchgangshöhe tiefer; vor jedem VerticalClearanceFilter beliebig viel tiefer. Auf einer Kante oder Ecke meint er alles, was dort zusammentrifft. Was entfällt, bleibt ein Hindernis.</translation>
    </message>
    <message>
        <source>Every walkable region holds a seed, or is reached over drops from one that does.</source>
        <translation>Jede begehbare Region enthält einen Startpunkt oder wird über Sprünge von einer erreicht, die einen enthält.</translation>
    </message>
    <message>
        <source>A VerticalClearanceFilter comes before it.</source>
        <translation>Ein VerticalClearanceFilter geht voran.</translation>
    </message>
    <message>
        <source>Every stretch on which two borders coincide in the plan is linked exactly where their heights differ by at most the step and nothing lies higher than the step above the lower one and within the clearance above the higher one. Borders that face each other across a gap are linked where that is proven of all ways over it, straight along the plan; a stretch of at most twice the gap only where both floors do not hang together right there anyway. Filters that follow keep links where they leave both borders; another StepFilter adds to them.</source>
        <translation>Jede Strecke, auf der zwei Ränder im Grundriss zusammenfallen, wird genau dort verbunden, wo sich ihre Höhen höchstens um die Stufe unterscheiden und nichts höher als die Stufe über dem unteren und innerhalb der lichten Höhe über dem oberen liegt. Ränder, die einander über eine Lücke gegenüberliegen, werden verbunden, wo das für alle geraden Wege im Grundriss darüber bewiesen ist; eine Strecke von höchstens der doppelten Lücke nur, wo beide Flächen nicht ohnehin genau dort zusammenhängen. Folgende Filter behalten Verbindungen, wo sie beide Ränder übrig lassen; ein weiterer StepFilter fügt welche hinzu.</translation>
    </message>
    <message>
        <source>Removes the places that are too near the border of the walkable area for an agent with a body: walls, edges that it could fall from, and the ends of the level. Distances are those of the shortest walk, seen from above; steps are no border.</source>
        <translation>Entfernt die Stellen, die für einen Agenten mit einem Körper zu nah am Rand der begehbaren Fläche sind: an Wänden, an Kanten, von denen er fallen könnte, und an den Enden des Levels. Abstände sind die des kürzesten Weges, von oben gesehen; Stufen sind kein Rand.</translation>
    </message>
</context>
<context>
    <name>ViewMode</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Hidden line</source>
        <translation>Verdeckte Kanten</translation>
    </message>
    <message>
        <source>Walkable only</source>
        <translation>Nur Begehbares</translation>
    </message>
    <message>
        <source>Rejected by</source>
        <translation>Verworfen durch</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Durchgangshöhe</translation>
    </message>
    <message>
        <source>Source triangles</source>
        <translation>Quelldreiecke</translation>
    </message>
    <message>
        <source>What is walkable, and why the rest is not</source>
        <translation>Was begehbar ist, und warum der Rest nicht</translation>
    </message>
    <message>
        <source>The edges of all triangles; nothing hides anything</source>
        <translation>Die Kanten aller Dreiecke; nichts verdeckt etwas</translation>
    </message>
    <message>
        <source>The edges of the triangles that are in front</source>
        <translation>Die Kanten der vorderen Dreiecke</translation>
    </message>
    <message>
        <source>The walkable area without the environment</source>
        <translation>Die begehbare Fläche ohne die Umgebung</translation>
    </message>
    <message>
        <source>Floors in the colour of the filter that removed them</source>
        <translation>Böden in der Farbe des Filters, der sie entfernt hat</translation>
    </message>
    <message>
        <source>Floors by their slope in degrees, with the limit of the filter</source>
        <translation>Böden nach ihrer Neigung in Grad, mit der Grenze des Filters</translation>
    </message>
    <message>
        <source>Floors by the free height above them, with the limit of the filter</source>
        <translation>Böden nach der freien Höhe darüber, mit der Grenze des Filters</translation>
    </message>
    <message>
        <source>Walkable pieces by the triangle of the environment they come from</source>
        <translation>Begehbare Stücke nach dem Dreieck der Umgebung, aus dem sie stammen</translation>
    </message>
</context>
<context>
    <name>WhyText</name>
    <message>
        <source>Walkable</source>
        <translation>Begehbar</translation>
    </message>
    <message>
        <source>Walkable, on an obstacle edge</source>
        <translation>Begehbar, auf einer Hinderniskante</translation>
    </message>
    <message>
        <source>Not walkable: a wall</source>
        <translation>Nicht begehbar: eine Wand</translation>
    </message>
    <message>
        <source>Not walkable: faces down</source>
        <translation>Nicht begehbar: zeigt nach unten</translation>
    </message>
    <message>
        <source>Not walkable: an obstacle only</source>
        <translation>Nicht begehbar: nur Hindernis</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>It belongs to component %1 of %2, with an area of %3.</source>
        <translation>Es gehört zu Teil %1 von %2, mit einer Fläche von %3.</translation>
    </message>
    <message>
        <source>Layer %1.</source>
        <translation>Ebene %1.</translation>
    </message>
    <message>
        <source>The triangle stands upright; nobody can stand on it. What it crosses becomes obstacle edges.</source>
        <translation>Das Dreieck steht aufrecht; niemand kann darauf stehen. Was es kreuzt, wird zu Hinderniskanten.</translation>
    </message>
    <message>
        <source>Only triangles that face up are floors. If the file&apos;s winding is unreliable, let both sides count as up.</source>
        <translation>Nur Dreiecke, die nach oben zeigen, sind Böden. Ist der Umlaufsinn der Datei unzuverlässig, lassen Sie beide Seiten als oben zählen.</translation>
    </message>
    <message>
        <source>This part of the environment is marked as an obstacle only.</source>
        <translation>Dieser Teil der Umgebung ist als nur Hindernis markiert.</translation>
    </message>
    <message>
        <source>The floor here is triangle %1, in the same plane.</source>
        <translation>Der Boden hier ist Dreieck %1, in derselben Ebene.</translation>
    </message>
    <message>
        <source>Exactly here stands a wall: triangle %1.</source>
        <translation>Genau hier steht eine Wand: Dreieck %1.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>unlimited: nothing is above</source>
        <translation>unbegrenzt: Nichts ist darüber</translation>
    </message>
    <message>
        <source>%1, below triangle %2</source>
        <translation>%1, unter Dreieck %2</translation>
    </message>
    <message>
        <source>a wall at %1</source>
        <translation>eine Wand in %1</translation>
    </message>
    <message>
        <source>a ledge at %1</source>
        <translation>eine Kante in %1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between two borders</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Not walkable</source>
        <translation>Nicht begehbar</translation>
    </message>
    <message>
        <source>The filter of this step removed it.</source>
        <translation>Der Filter dieses Schritts hat es entfernt.</translation>
    </message>
</context>
<context>
    <name>WhyTool</name>
    <message>
        <source>Why? Click a place (or press Return over it); Esc ends.</source>
        <translation>Warum? Klicken Sie eine Stelle an (oder Eingabe darüber); Esc beendet.</translation>
    </message>
</context>
<context>
    <name>footfall::ui</name>
    <message>
        <source>Add agent %1</source>
        <translation>Agent %1 hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate agent %1</source>
        <translation>Agent %1 verdoppeln</translation>
    </message>
    <message>
        <source>Remove agent %1</source>
        <translation>Agent %1 entfernen</translation>
    </message>
    <message>
        <source>Rename agent %1 → %2</source>
        <translation>Agent %1 → %2 umbenennen</translation>
    </message>
    <message>
        <source>Change height of %1 %2 → %3</source>
        <translation>Höhe von %1 ändern %2 → %3</translation>
    </message>
    <message>
        <source>Change maximum slope of %1 %2 → %3</source>
        <translation>Größte Neigung von %1 ändern %2 → %3</translation>
    </message>
    <message>
        <source>Switch to agent %1</source>
        <translation>Zu Agent %1 wechseln</translation>
    </message>
    <message>
        <source>Deactivate the agent</source>
        <translation>Agenten deaktivieren</translation>
    </message>
    <message>
        <source>Agent</source>
        <translation>Agent</translation>
    </message>
    <message>
        <source>Human</source>
        <translation>Mensch</translation>
    </message>
    <message>
        <source>Child</source>
        <translation>Kind</translation>
    </message>
    <message>
        <source>Wheelchair</source>
        <translation>Rollstuhl</translation>
    </message>
    <message>
        <source>Cart</source>
        <translation>Wagen</translation>
    </message>
    <message>
        <source>Giant</source>
        <translation>Riese</translation>
    </message>
    <message>
        <source>Crawler</source>
        <translation>Kriecher</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Thread</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Estimated cost</source>
        <translation>Geschätzter Aufwand</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>under 0.01 ms</source>
        <translation>unter 0,01 ms</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>%1 units of work</source>
        <translation>%1 Arbeitseinheiten</translation>
    </message>
    <message>
        <source>thread %1</source>
        <translation>Thread %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Change %1 %2 → %3</source>
        <translation>%1 ändern %2 → %3</translation>
    </message>
    <message>
        <source>%1 filters</source>
        <translation>%1 Filter</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 verdoppeln</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>%1 nach unten</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Run only up to %1</source>
        <translation>Nur bis %1 ausführen</translation>
    </message>
    <message>
        <source>Switch off all but %1</source>
        <translation>Alle außer %1 ausschalten</translation>
    </message>
    <message>
        <source>Switch on all filters</source>
        <translation>Alle Filter einschalten</translation>
    </message>
    <message>
        <source>Run &amp;automatically</source>
        <translation>&amp;Selbsttätig ausführen</translation>
    </message>
    <message>
        <source>Run after each edit; off: F5 runs</source>
        <translation>Nach jeder Änderung ausführen; aus: F5 führt aus</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Undo history</source>
        <translation>Verlauf der Änderungen</translation>
    </message>
    <message>
        <source>All edits; choose one to go back to it</source>
        <translation>Alle Änderungen; wählen Sie eine, um zu ihr zurückzukehren</translation>
    </message>
    <message>
        <source>Agents</source>
        <translation>Agenten</translation>
    </message>
    <message>
        <source>The agents of the level: their sizes set the filters, and a table compares what each can reach</source>
        <translation>Die Agenten des Levels: Ihre Maße bestimmen die Filter, und eine Tabelle vergleicht, was jeder erreicht</translation>
    </message>
    <message>
        <source>Agent %1</source>
        <translation>Agent %1</translation>
    </message>
    <message>
        <source>Set the filters to this agent&apos;s sizes</source>
        <translation>Die Filter auf die Maße dieses Agenten setzen</translation>
    </message>
    <message>
        <source>&amp;No agent</source>
        <translation>&amp;Kein Agent</translation>
    </message>
    <message>
        <source>Deactivate the agent; the filters keep their values</source>
        <translation>Den Agenten deaktivieren; die Filter behalten ihre Werte</translation>
    </message>
    <message>
        <source>&amp;Compute all agents</source>
        <translation>Alle Agenten &amp;berechnen</translation>
    </message>
    <message>
        <source>Compute the results of all agents in the background</source>
        <translation>Die Ergebnisse aller Agenten im Hintergrund berechnen</translation>
    </message>
    <message>
        <source>Agent: %1</source>
        <translation>Agent: %1</translation>
    </message>
    <message>
        <source>Sequential</source>
        <translation>Nacheinander</translation>
    </message>
    <message>
        <source>The filters of a new environment</source>
        <translation>Die Filter einer neuen Umgebung</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>The same result, with the clearance in cells on all threads</source>
        <translation>Dasselbe Ergebnis, mit der Durchgangshöhe in Zellen auf allen Threads</translation>
    </message>
    <message>
        <source>Thesis, sequential</source>
        <translation>Dissertation, nacheinander</translation>
    </message>
    <message>
        <source>As in the thesis&apos;s experiments (5.4), in the units of its environments</source>
        <translation>Wie in den Versuchen der Dissertation (5.4), in den Einheiten ihrer Umgebungen</translation>
    </message>
    <message>
        <source>Thesis, parallel</source>
        <translation>Dissertation, parallel</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>noch nicht gelaufen</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>cached</source>
        <translation>gemerkt</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 Dreieck</translation>
    </message>
    <message>
        <source>Pr&amp;esets</source>
        <translation>Vo&amp;rlagen</translation>
    </message>
    <message>
        <source>Len&amp;gths in</source>
        <translation>Län&amp;gen in</translation>
    </message>
    <message>
        <source>&amp;Metres</source>
        <translation>&amp;Meter</translation>
    </message>
    <message>
        <source>Show and type lengths in metres, where the scale of the level is known</source>
        <translation>Längen in Metern zeigen und eingeben, wo der Maßstab des Levels bekannt ist</translation>
    </message>
    <message>
        <source>&amp;Feet</source>
        <translation>&amp;Fuß</translation>
    </message>
    <message>
        <source>Show and type lengths in feet, where the scale of the level is known</source>
        <translation>Längen in Fuß zeigen und eingeben, wo der Maßstab des Levels bekannt ist</translation>
    </message>
    <message>
        <source>File&apos;s &amp;units</source>
        <translation>&amp;Einheiten der Datei</translation>
    </message>
    <message>
        <source>Show and type lengths as the file has them</source>
        <translation>Längen zeigen und eingeben, wie die Datei sie hat</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open sample %1</source>
        <translation>Beispiel %1 öffnen</translation>
    </message>
    <message>
        <source>Change step of %1 %2 → %3</source>
        <translation>Stufe von %1 ändern %2 → %3</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Place seed %1</source>
        <translation>Startpunkt %1 setzen</translation>
    </message>
    <message>
        <source>Move seed %1</source>
        <translation>Startpunkt %1 verschieben</translation>
    </message>
    <message>
        <source>Remove seed %1</source>
        <translation>Startpunkt %1 entfernen</translation>
    </message>
    <message>
        <source>Change gap of %1 %2 → %3</source>
        <translation>Lücke von %1 ändern: %2 → %3</translation>
    </message>
    <message>
        <source>Change radius of %1 %2 → %3</source>
        <translation>Radius von %1 ändern: %2 → %3</translation>
    </message>
    <message>
        <source>Change drop of %1 %2 → %3</source>
        <translation>Sprung von %1 ändern: %2 → %3</translation>
    </message>
    <message>
        <source>2 m, slopes up to 45°, stairs: risers up to 0.22 m, gaps up to 0.05 m, shoulders: a radius of 0.27 m</source>
        <translation>2 m, Neigungen bis 45°, Treppen: Stufen bis 0,22 m, Lücken bis 0,05 m, Schultern: ein Radius von 0,27 m</translation>
    </message>
    <message>
        <source>1.2 m, slopes up to 45°, stairs: risers up to 0.22 m, gaps up to 0.05 m, a radius of 0.18 m</source>
        <translation>1,2 m, Neigungen bis 45°, Treppen: Stufen bis 0,22 m, Lücken bis 0,05 m, ein Radius von 0,18 m</translation>
    </message>
    <message>
        <source>1.5 m, slopes up to 5° (ramps of 1 in 12 are 4.76°), thresholds and gaps up to 0.013 m, a radius of 0.38 m</source>
        <translation>1,5 m, Neigungen bis 5° (Rampen von 1 zu 12 haben 4,76°), Schwellen und Lücken bis 0,013 m, ein Radius von 0,38 m</translation>
    </message>
    <message>
        <source>1.2 m, slopes up to 10°, thresholds and gaps up to 0.013 m, a radius of 0.3 m</source>
        <translation>1,2 m, Neigungen bis 10°, Schwellen und Lücken bis 0,013 m, ein Radius von 0,3 m</translation>
    </message>
    <message>
        <source>4 m, slopes up to 45°, steps up to 0.8 m, gaps up to 0.1 m, a radius of 1 m</source>
        <translation>4 m, Neigungen bis 45°, Stufen bis 0,8 m, Lücken bis 0,1 m, ein Radius von 1 m</translation>
    </message>
    <message>
        <source>0.5 m, slopes up to 60°, steps up to 0.1 m, gaps up to 0.02 m, a radius of 0.2 m</source>
        <translation>0,5 m, Neigungen bis 60°, Stufen bis 0,1 m, Lücken bis 0,02 m, ein Radius von 0,2 m</translation>
    </message>
    <message>
        <source>A robot on four legs: 0.84 m, slopes up to 30°, steps up to 0.3 m, gaps up to 0.05 m, a radius of 0.25 m</source>
        <translation>Ein Roboter auf vier Beinen: 0,84 m, Neigungen bis 30°, Stufen bis 0,3 m, Lücken bis 0,05 m, ein Radius von 0,25 m</translation>
    </message>
    <message>
        <source>Unity&apos;s default: 2 m, slopes up to 45°, steps up to 0.75 m, a radius of 0.5 m</source>
        <translation>Voreinstellung von Unity: 2 m, Neigungen bis 45°, Stufen bis 0,75 m, ein Radius von 0,5 m</translation>
    </message>
    <message>
        <source>Unreal&apos;s default: 1.44 m, slopes up to 44°, steps up to 0.35 m, a radius of 0.34 m</source>
        <translation>Voreinstellung von Unreal: 1,44 m, Neigungen bis 44°, Stufen bis 0,35 m, ein Radius von 0,34 m</translation>
    </message>
    <message>
        <source>Godot&apos;s default: 1.5 m, slopes up to 45°, steps up to 0.25 m, a radius of 0.5 m</source>
        <translation>Voreinstellung von Godot: 1,5 m, Neigungen bis 45°, Stufen bis 0,25 m, ein Radius von 0,5 m</translation>
    </message>
    <message>
        <source>The default of Recast&apos;s demo: 2 m, slopes up to 45°, steps up to 0.9 m, a radius of 0.6 m</source>
        <translation>Voreinstellung der Demo von Recast: 2 m, Neigungen bis 45°, Stufen bis 0,9 m, ein Radius von 0,6 m</translation>
    </message>
    <message>
        <source>M&amp;illimetres</source>
        <translation>M&amp;illimeter</translation>
    </message>
    <message>
        <source>Show and type lengths in millimetres, and areas in square metres, where the scale of the level is known</source>
        <translation>Längen in Millimetern und Flächen in Quadratmetern zeigen und eingeben, wo der Maßstab des Levels bekannt ist</translation>
    </message>
    <message>
        <source>Thread %1</source>
        <translation>Thread %1</translation>
    </message>
    <message>
        <source>Editor, thread %1</source>
        <translation>Editor, Thread %1</translation>
    </message>
    <message>
        <source>Rank %1, thread %2</source>
        <translation>Rang %1, Thread %2</translation>
    </message>
    <message>
        <source>already inside a parallel block</source>
        <translation>schon in einem parallelen Block</translation>
    </message>
    <message>
        <source>no parallel block to end here</source>
        <translation>hier endet kein paralleler Block</translation>
    </message>
    <message>
        <source>not inside a parallel block: it needs all cells</source>
        <translation>nicht in einem parallelen Block: er braucht alle Zellen</translation>
    </message>
    <message>
        <source>needs Vertical clearance before it</source>
        <translation>braucht davor die Durchgangshöhe</translation>
    </message>
    <message>
        <source>the parallel block has an end already</source>
        <translation>der parallele Block hat schon ein Ende</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>übersprungen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::AgentModel</name>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>nicht berechnet</translation>
    </message>
    <message>
        <source>Alt+%1</source>
        <translation>Alt+%1</translation>
    </message>
    <message>
        <source>Agent</source>
        <translation>Agent</translation>
    </message>
    <message>
        <source>Slope (°)</source>
        <translation>Neigung (°)</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>The free height that the agent needs: the clearance of the filters</source>
        <translation>Die freie Höhe, die der Agent braucht: die Durchgangshöhe der Filter</translation>
    </message>
    <message>
        <source>The steepest ground that the agent can walk on</source>
        <translation>Der steilste Boden, auf dem der Agent gehen kann</translation>
    </message>
    <message>
        <source>Parts of the walkable area that an agent cannot leave</source>
        <translation>Teile der begehbaren Fläche, die ein Agent nicht verlassen kann</translation>
    </message>
    <message>
        <source>Edges on which two layers meet</source>
        <translation>Kanten, an denen sich zwei Ebenen treffen</translation>
    </message>
    <message>
        <source>Ready: switching to the agent shows its result at once</source>
        <translation>Bereit: Der Wechsel zum Agenten zeigt sein Ergebnis sofort</translation>
    </message>
    <message>
        <source>agent: %1</source>
        <translation>Agent: %1</translation>
    </message>
    <message>
        <source>%1 units of the file</source>
        <translation>%1 Einheiten der Datei</translation>
    </message>
    <message>
        <source>Height (%1)</source>
        <translation>Höhe (%1)</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>Fläche (%1)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number; write for example %2</source>
        <translation>„%1“ ist keine Zahl; schreiben Sie zum Beispiel %2</translation>
    </message>
    <message>
        <source>Step (%1)</source>
        <translation>Stufe (%1)</translation>
    </message>
    <message>
        <source>The highest step that the agent climbs, such as a stair or a kerb: the step of the filters. 0 means no filter for steps</source>
        <translation>Die höchste Stufe, die der Agent steigt, etwa auf Treppen oder an Bordsteinen: die Stufe der Filter. 0 bedeutet: kein Filter für Stufen</translation>
    </message>
    <message>
        <source>Gap (%1)</source>
        <translation>Lücke (%1)</translation>
    </message>
    <message>
        <source>Radius (%1)</source>
        <translation>Radius (%1)</translation>
    </message>
    <message>
        <source>Drop (%1)</source>
        <translation>Sprung (%1)</translation>
    </message>
    <message>
        <source>The widest gap that the agent steps over, seen from above: the gap of the filters for steps</source>
        <translation>Die breiteste Lücke, über die der Agent tritt, von oben gesehen: die Lücke der Filter für Stufen</translation>
    </message>
    <message>
        <source>The distance that the agent&apos;s middle keeps from walls and ledges: the radius of the filters. 0 means no filter for it</source>
        <translation>Der Abstand, den die Mitte des Agenten von Wänden und Kanten hält: der Radius der Filter. 0 bedeutet: kein Filter dafür</translation>
    </message>
    <message>
        <source>The deepest drop that the agent takes from a ledge, one way: the depth of the filters. 0 means no filter for drops</source>
        <translation>Der tiefste Sprung, den der Agent von einer Kante macht, nur hinab: die Tiefe der Filter. 0 bedeutet: kein Filter für Sprünge</translation>
    </message>
</context>
<context>
    <name>footfall::ui::AgentsPanel</name>
    <message>
        <source>Agents and their results</source>
        <translation>Agenten und ihre Ergebnisse</translation>
    </message>
    <message>
        <source>Add filters</source>
        <translation>Filter hinzufügen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add an agent; it becomes the active one</source>
        <translation>Einen Agenten hinzufügen; er wird der aktive</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Copy the active agent</source>
        <translation>Den aktiven Agenten kopieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the active agent; the filters stay as they are</source>
        <translation>Den aktiven Agenten entfernen; die Filter bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Deactivate the agent; the filters keep their values (Alt+0)</source>
        <translation>Den Agenten deaktivieren; die Filter behalten ihre Werte (Alt+0)</translation>
    </message>
    <message>
        <source>Compute all</source>
        <translation>Alle berechnen</translation>
    </message>
    <message>
        <source>Compute the results of all agents in the background, to switch and to compare at once</source>
        <translation>Die Ergebnisse aller Agenten im Hintergrund berechnen, um sofort wechseln und vergleichen zu können</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>As &amp;text</source>
        <translation>Als &amp;Text</translation>
    </message>
    <message>
        <source>As &amp;CSV</source>
        <translation>Als &amp;CSV</translation>
    </message>
    <message>
        <source>Agents computed</source>
        <translation>Agenten berechnet</translation>
    </message>
    <message>
        <source>No filter &apos;%1&apos; is on: that size of the agents has no effect.</source>
        <translation>Kein Filter „%1“ ist an: Dieses Maß der Agenten wirkt nicht.</translation>
    </message>
    <message>
        <source>&apos; and no filter &apos;</source>
        <comment>between two names of filters</comment>
        <translation>“ und kein Filter „</translation>
    </message>
    <message>
        <source>Add the filters of agents</source>
        <translation>Die Filter der Agenten hinzufügen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Add the filters that the agents drive, before all others; steps and drops behind the clearance</source>
        <translation>Fügt die Filter, die Agenten steuern, vor allen anderen hinzu; Stufen und Sprünge hinter der Durchgangshöhe</translation>
    </message>
    <message>
        <source>The filter &apos;%1&apos; has no place in the list: %2</source>
        <translation>Der Filter „%1“ hat keinen Platz in der Liste: %2</translation>
    </message>
    <message>
        <source>An agent has the sizes that the filters follow: height, slope, step, gap, radius and drop. Add one to compare what each can reach.</source>
        <translation>Ein Agent hat die Maße, denen die Filter folgen: Höhe, Neigung, Stufe, Lücke, Radius und Sprung. Fügen Sie einen hinzu, um zu vergleichen, was jeder erreicht.</translation>
    </message>
    <message>
        <source>Sizes of the &amp;filters</source>
        <translation>Maße der &amp;Filter</translation>
    </message>
</context>
<context>
    <name>footfall::ui::AxisGizmo</name>
    <message>
        <source>From the top</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the back</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>Axes of the view</source>
        <translation>Achsen der Ansicht</translation>
    </message>
    <message>
        <source>Axes of the file: %1</source>
        <translation>Achsen der Datei: %1</translation>
    </message>
    <message>
        <source>The file&apos;s axes (%1). Click one to look along it; drag to turn</source>
        <translation>Die Achsen der Datei (%1). Klick auf eine blickt an ihr entlang; Ziehen dreht</translation>
    </message>
</context>
<context>
    <name>footfall::ui::BodyFields</name>
    <message>
        <source>Radius of the body</source>
        <translation>Radius des Körpers</translation>
    </message>
    <message>
        <source>Radius of the body that walks, half of its width. 0: a point, on the result as it is</source>
        <translation>Radius des Körpers, der geht: die Hälfte seiner Breite. 0: ein Punkt, auf dem Ergebnis, wie es ist</translation>
    </message>
    <message>
        <source>Drag to see where a wider body fits</source>
        <translation>Ziehen zeigt, wo ein breiterer Körper durchpasst</translation>
    </message>
    <message>
        <source>Which way the body takes</source>
        <translation>Weg, den der Körper nimmt</translation>
    </message>
    <message>
        <source>Which of several ways the body takes. Passages that are twice as wide as the body, or wider, count as wide</source>
        <translation>Welchen von mehreren Wegen der Körper nimmt. Als breit gelten Durchgänge, die mindestens doppelt so breit sind wie der Körper</translation>
    </message>
    <message>
        <source>Shortest way</source>
        <translation>Kürzester Weg</translation>
    </message>
    <message>
        <source>Prefer wide passages</source>
        <translation>Breite Durchgänge vorziehen</translation>
    </message>
    <message>
        <source>Widest way</source>
        <translation>Breitester Weg</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Weg</translation>
    </message>
</context>
<context>
    <name>footfall::ui::BottleneckModel</name>
    <message>
        <source>%1 | %2, the only way</source>
        <translation>%1 | %2, einziger Weg</translation>
    </message>
    <message>
        <source>up to %1 | %2 wide</source>
        <translation>bis %1 | %2 breit</translation>
    </message>
    <message>
        <source>too narrow</source>
        <translation>zu schmal</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>Width (%1)</source>
        <translation>Breite (%1)</translation>
    </message>
    <message>
        <source>Agent</source>
        <translation>Agent</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Place (%1)</source>
        <translation>Ort (%1)</translation>
    </message>
    <message>
        <source>Sides: %1</source>
        <translation>Seiten: %1</translation>
    </message>
    <message>
        <source>The widest place on either side that is reached without going through anything as narrow. Where there is no other way: the walkable areas on both sides</source>
        <translation>Die breiteste Stelle auf jeder Seite, die erreicht wird, ohne durch etwas ebenso Schmales zu gehen. Wo es keinen anderen Weg gibt: die begehbaren Flächen auf beiden Seiten</translation>
    </message>
</context>
<context>
    <name>footfall::ui::BusyPlot</name>
    <message>
        <source>pre-processing</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>partitioning</source>
        <translation>Aufteilung</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>merging</source>
        <translation>Zusammenfügen</translation>
    </message>
    <message>
        <source>post-processing</source>
        <translation>Nachbereitung</translation>
    </message>
    <message>
        <source>overhead</source>
        <translation>Zusatzaufwand</translation>
    </message>
    <message>
        <source>Time that each thread was busy</source>
        <translation>Wie lange jeder Thread beschäftigt war</translation>
    </message>
    <message>
        <source>busy with cells (ms); line: mean</source>
        <translation>mit Zellen beschäftigt (ms); Linie: Mittel</translation>
    </message>
    <message>
        <source>estimated work (units); line: mean</source>
        <translation>geschätzte Arbeit (Einheiten); Linie: Mittel</translation>
    </message>
    <message>
        <source>Thread %1</source>
        <translation>Thread %1</translation>
    </message>
    <message>
        <source>Thread %1 would have %2</source>
        <translation>Thread %1 hätte %2</translation>
    </message>
    <message>
        <source>Thread %1 was busy for %2</source>
        <translation>Thread %1 war %2 lang beschäftigt</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Rang %1</translation>
    </message>
    <message>
        <source>Rank %1 was busy for %2</source>
        <translation>Rang %1 war %2 lang beschäftigt</translation>
    </message>
    <message>
        <source>other steps</source>
        <translation>andere Schritte</translation>
    </message>
    <message>
        <source>waiting for work</source>
        <translation>Warten auf Arbeit</translation>
    </message>
    <message>
        <source>waiting for a serial step</source>
        <translation>Warten auf einen seriellen Schritt</translation>
    </message>
    <message>
        <source>other programs</source>
        <translation>andere Programme</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CameraTools</name>
    <message>
        <source>From &amp;below</source>
        <translation>Von &amp;unten</translation>
    </message>
    <message>
        <source>Look straight up</source>
        <translation>Senkrecht nach oben sehen</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>From the bac&amp;k</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>From the ri&amp;ght</source>
        <translation>Von &amp;rechts</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>&amp;Perspective or parallel</source>
        <translation>&amp;Perspektive oder parallel</translation>
    </message>
    <message>
        <source>Switch between perspective and parallel projection</source>
        <translation>Zwischen perspektivischer und paralleler Projektion wechseln</translation>
    </message>
    <message>
        <source>Frame &amp;selection</source>
        <translation>&amp;Auswahl ins Bild</translation>
    </message>
    <message>
        <source>Bring the selection, or the place under the mouse, into view</source>
        <translation>Die Auswahl oder die Stelle unter der Maus ins Bild bringen</translation>
    </message>
    <message>
        <source>&amp;Fly</source>
        <translation>&amp;Fliegen</translation>
    </message>
    <message>
        <source>Move through the level with W A S D, Q and E, and look with the mouse</source>
        <translation>Mit W A S D, Q und E durch das Level bewegen und mit der Maus umsehen</translation>
    </message>
    <message>
        <source>Glide to &amp;new views</source>
        <translation>Zu &amp;neuen Ansichten gleiten</translation>
    </message>
    <message>
        <source>Animate jumps of the camera; switch off to reduce motion</source>
        <translation>Sprünge der Kamera animieren; ausschalten für weniger Bewegung</translation>
    </message>
    <message>
        <source>&amp;Keep this view...</source>
        <translation>Diese Ansicht &amp;behalten...</translation>
    </message>
    <message>
        <source>Save the camera position under a name</source>
        <translation>Die Kameraposition unter einem Namen merken</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Vergessen</translation>
    </message>
    <message>
        <source>Keep this view</source>
        <translation>Diese Ansicht behalten</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>No view is saved there; Ctrl+Alt+%1 saves this one</source>
        <translation>Dort ist keine Ansicht gemerkt; Strg+Alt+%1 merkt diese</translation>
    </message>
    <message>
        <source>No bookmarks; Ctrl+Alt+1 to 9 saves one, Ctrl+Shift+1 to 9 goes there</source>
        <translation>Keine Lesezeichen; Strg+Alt+1 bis 9 merkt eines, Strg+Umschalt+1 bis 9 führt dorthin</translation>
    </message>
    <message>
        <source>Name of the view (Ctrl+Shift+%1 goes back to it):</source>
        <translation>Name der Ansicht (Strg+Umschalt+%1 führt dorthin zurück):</translation>
    </message>
    <message>
        <source>Kept &apos;%1&apos;; Ctrl+Shift+%2 goes back to it</source>
        <translation>„%1“ gemerkt; Strg+Umschalt+%2 führt dorthin zurück</translation>
    </message>
    <message>
        <source>Fly: %1 %2 a second</source>
        <translation>Fliegen: %1 %2 je Sekunde</translation>
    </message>
    <message>
        <source>Look level, from the front</source>
        <translation>Waagerecht blicken, von vorn</translation>
    </message>
    <message>
        <source>Look level, from the back</source>
        <translation>Waagerecht blicken, von hinten</translation>
    </message>
    <message>
        <source>Look level, from the right</source>
        <translation>Waagerecht blicken, von rechts</translation>
    </message>
    <message>
        <source>Look level, from the left</source>
        <translation>Waagerecht blicken, von links</translation>
    </message>
    <message>
        <source>Book&amp;marks</source>
        <translation>&amp;Merkpunkte</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CellLegend</name>
    <message>
        <source>Colour cells by</source>
        <translation>Zellen einfärben nach</translation>
    </message>
    <message>
        <source>What the colours of the cells show</source>
        <translation>Was die Farben der Zellen zeigen</translation>
    </message>
    <message>
        <source>not finished yet</source>
        <translation>noch nicht fertig</translation>
    </message>
    <message>
        <source>No cells</source>
        <translation>Keine Zellen</translation>
    </message>
    <message>
        <source>The pipeline has no parallel block, or it has not run yet.</source>
        <translation>Die Pipeline hat keinen parallelen Block, oder er ist noch nicht gelaufen.</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>%1, before a run</source>
        <translation>%1, vor einem Lauf</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>0 bis %1</translation>
    </message>
    <message>
        <source> of work</source>
        <translation> Arbeit</translation>
    </message>
    <message>
        <source> that go in</source>
        <translation>, die hineingehen</translation>
    </message>
    <message>
        <source>, estimated</source>
        <translation>, geschätzt</translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation>Farben: %1</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Thread that began the cell; its share of the work:</source>
        <translation>Thread, der die Zelle begonnen hat; sein Anteil an der Arbeit:</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weiterer</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Thread %1: %2 %, %3, %n cell(s)</source>
        <translation>
            <numerusform>Thread %1: %2 %, %3, %n Zelle</numerusform>
            <numerusform>Thread %1: %2 %, %3, %n Zellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Rank that ran the cell; its share of the work:</source>
        <translation>Rang, der die Zelle berechnete; sein Anteil an der Arbeit:</translation>
    </message>
    <message numerus="yes">
        <source>Rank %1: %2 %, %3, %n cell(s)</source>
        <translation>
            <numerusform>Rang %1: %2 %, %3, %n Zelle</numerusform>
            <numerusform>Rang %1: %2 %, %3, %n Zellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>More: darkest; at most %1</source>
        <translation>Mehr: am dunkelsten; höchstens %1</translation>
    </message>
    <message>
        <source>Nothing has run yet: an estimate stands in</source>
        <translation>Noch ist nichts gelaufen: gezeigt wird eine Schätzung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CellModel</name>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>estimated cost</source>
        <translation>geschätzter Aufwand</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>%1 in, %2 out</source>
        <translation>%1 hinein, %2 heraus</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>Thread</translation>
    </message>
    <message>
        <source>%1, helped by %2</source>
        <translation>%1, mit Hilfe von %2</translation>
    </message>
    <message>
        <source>%1 in</source>
        <translation>%1 hinein</translation>
    </message>
    <message>
        <source>Cell %1 of %2</source>
        <translation>Zelle %1 von %2</translation>
    </message>
    <message>
        <source> (preview)</source>
        <translation> (Vorschau)</translation>
    </message>
    <message>
        <source> (not finished)</source>
        <translation> (nicht fertig)</translation>
    </message>
    <message>
        <source>below %1 %2</source>
        <translation>unter %1 %2</translation>
    </message>
    <message>
        <source>from %1 %2</source>
        <translation>ab %1 %2</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>height (%1)</source>
        <translation>Höhe (%1)</translation>
    </message>
    <message>
        <source>rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>all, with the figures of that run</source>
        <translation>alles, mit den Zahlen jenes Laufs</translation>
    </message>
    <message>
        <source>%1 of %2 floors</source>
        <translation>%1 von %2 Böden</translation>
    </message>
    <message>
        <source>from the cache</source>
        <translation>aus dem Cache</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CellsFeature</name>
    <message>
        <source>Load</source>
        <translation>Auslastung</translation>
    </message>
    <message>
        <source>Run in &amp;parallel</source>
        <translation>&amp;Parallel ausführen</translation>
    </message>
    <message>
        <source>Put an automatic strategy and a Collapse around the local filters</source>
        <translation>Eine automatische Strategie und ein Collapse um die lokalen Filter setzen</translation>
    </message>
    <message>
        <source>Pre&amp;view cells</source>
        <translation>Zellen-&amp;Vorschau</translation>
    </message>
    <message>
        <source>&amp;Cells</source>
        <translation>&amp;Zellen</translation>
    </message>
    <message>
        <source>Show the cells of the parallel block</source>
        <translation>Die Zellen des parallelen Blocks zeigen</translation>
    </message>
    <message>
        <source>&amp;Load</source>
        <translation>A&amp;uslastung</translation>
    </message>
    <message>
        <source>Show how the work was spread over threads</source>
        <translation>Zeigen, wie die Arbeit auf Threads verteilt war</translation>
    </message>
    <message>
        <source>No local filter can run in parallel; add a clearance filter first.</source>
        <translation>Kein lokaler Filter kann parallel laufen; fügen Sie zuerst einen Höhenfilter hinzu.</translation>
    </message>
    <message>
        <source>This session was run on %1.</source>
        <translation>Diese Sitzung wurde gerechnet mit: %1.</translation>
    </message>
    <message>
        <source>Run there again</source>
        <translation>Wieder dort rechnen</translation>
    </message>
    <message>
        <source>Open an environment first.</source>
        <translation>Öffnen Sie zuerst eine Umgebung.</translation>
    </message>
    <message>
        <source>Only runs of this program can be measured; choose it under Run on.</source>
        <translation>Nur Läufe dieses Programms lassen sich messen; wählen Sie es unter „Rechnen auf“.</translation>
    </message>
    <message>
        <source>A run is under way; measure when it has finished.</source>
        <translation>Ein Lauf ist im Gang; messen Sie, wenn er fertig ist.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CommandPalette</name>
    <message>
        <source> (on)</source>
        <translation> (an)</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Search commands, filters, files and samples</source>
        <translation>Befehle, Filter, Dateien und Beispiele suchen</translation>
    </message>
    <message>
        <source>A few letters are enough; Enter does what is marked</source>
        <translation>Wenige Buchstaben genügen; die Eingabetaste führt das Markierte aus</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>%1, not available now</source>
        <translation>%1, jetzt nicht verfügbar</translation>
    </message>
    <message>
        <source>No command found</source>
        <translation>Kein Befehl gefunden</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CompareFeature</name>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Show what appeared and what disappeared since the last edit, or compared with a saved result</source>
        <translation>Zeigen, was seit der letzten Änderung oder gegenüber einem gespeicherten Ergebnis dazukam und was wegfiel</translation>
    </message>
    <message>
        <source>Compare with the Last Edit</source>
        <translation>Mit der letzten Änderung vergleichen</translation>
    </message>
    <message>
        <source>Show in the view what the last edit made walkable, and what is no longer walkable</source>
        <translation>In der Ansicht zeigen, was die letzte Änderung begehbar gemacht hat und was nicht mehr begehbar ist</translation>
    </message>
    <message>
        <source>Compare with a Saved Result…</source>
        <translation>Mit einem gespeicherten Ergebnis vergleichen …</translation>
    </message>
    <message>
        <source>Show in the view how an exported result, or another tool&apos;s mesh, differs</source>
        <translation>In der Ansicht zeigen, worin sich ein exportiertes Ergebnis oder das Netz eines anderen Programms unterscheidet</translation>
    </message>
    <message>
        <source>Compare with a saved result</source>
        <translation>Mit einem gespeicherten Ergebnis vergleichen</translation>
    </message>
    <message>
        <source>Results (*.obj)</source>
        <translation>Ergebnisse (*.obj)</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Vergleicht …</translation>
    </message>
    <message>
        <source>Choose what to compare the result with.</source>
        <translation>Wählen Sie, womit das Ergebnis verglichen werden soll.</translation>
    </message>
    <message>
        <source>There is no result yet; the comparison follows when a run has finished.</source>
        <translation>Es gibt noch kein Ergebnis; der Vergleich folgt, wenn ein Lauf beendet ist.</translation>
    </message>
    <message numerus="yes">
        <source>Distances, taken at %n corners: at most %1, mean %2, root mean square %3</source>
        <translation>
            <numerusform>Abstände, an %n Ecke gemessen: höchstens %1, Mittel %2, quadratisches Mittel %3</numerusform>
            <numerusform>Abstände, an %n Ecken gemessen: höchstens %1, Mittel %2, quadratisches Mittel %3</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no edit yet; the changes of the next edit will be shown here.</source>
        <translation>Es gibt noch keine Änderung; hier erscheint, was die nächste Änderung bewirkt.</translation>
    </message>
    <message numerus="yes">
        <source>Only the largest %n regions are drawn</source>
        <translation>
            <numerusform>Nur das größte Gebiet ist gezeichnet</numerusform>
            <numerusform>Nur die größten %n Gebiete sind gezeichnet</numerusform>
        </translation>
    </message>
    <message>
        <source>Distance to the other result</source>
        <translation>Abstand zum anderen Ergebnis</translation>
    </message>
    <message numerus="yes">
        <source>%n triangles with the smallest distances are not drawn</source>
        <translation>
            <numerusform>%n Dreieck mit dem kleinsten Abstand ist nicht gezeichnet</numerusform>
            <numerusform>%n Dreiecke mit den kleinsten Abständen sind nicht gezeichnet</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::ComparePanel</name>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Appeared: %1</source>
        <translation>Dazugekommen: %1</translation>
    </message>
    <message>
        <source>Disappeared: %1</source>
        <translation>Weggefallen: %1</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>The result before the last edit</source>
        <translation>Das Ergebnis vor der letzten Änderung</translation>
    </message>
    <message>
        <source>A saved result…</source>
        <translation>Ein gespeichertes Ergebnis …</translation>
    </message>
    <message>
        <source>What the result is compared with, after each run</source>
        <translation>Womit das Ergebnis nach jedem Lauf verglichen wird</translation>
    </message>
    <message>
        <source>Colour by &amp;distance</source>
        <translation>Nach &amp;Abstand färben</translation>
    </message>
    <message>
        <source>Colour the result by the distance of its vertices from the other one: red is zero, blue the largest</source>
        <translation>Das Ergebnis nach dem Abstand seiner Ecken vom anderen färben: rot ist null, blau der größte</translation>
    </message>
    <message>
        <source>Compare &amp;with</source>
        <translation>Vergleichen &amp;mit</translation>
    </message>
    <message>
        <source>Regions that differ, largest first</source>
        <translation>Gebiete, die sich unterscheiden, die größten zuerst</translation>
    </message>
    <message>
        <source>Click a region, or press Return on it, to bring it into sight</source>
        <translation>Klick auf ein Gebiet oder Eingabe darauf bringt es ins Bild</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>A saved result: %1</source>
        <translation>Ein gespeichertes Ergebnis: %1</translation>
    </message>
    <message>
        <source>Both results cover the same area.</source>
        <translation>Beide Ergebnisse bedecken dieselbe Fläche.</translation>
    </message>
    <message numerus="yes">
        <source>The largest %1 of %n regions are listed.</source>
        <translation>
            <numerusform>Aufgeführt sind die größten %1 von %n Gebiet.</numerusform>
            <numerusform>Aufgeführt sind die größten %1 von %n Gebieten.</numerusform>
        </translation>
    </message>
    <message>
        <source>appeared</source>
        <translation>dazugekommen</translation>
    </message>
    <message>
        <source>disappeared</source>
        <translation>weggefallen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CompareWatch</name>
    <message>
        <source>The comparison: memory ran out; close other programs or use a smaller environment</source>
        <translation>Der Vergleich: Der Speicher ging aus; schließen Sie andere Programme, oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ComponentsModel</name>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Of the surface; the largest is the first</source>
        <translation>Der Oberfläche; das größte ist das erste</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>Fläche (%1)</translation>
    </message>
    <message>
        <source>Centre (%1)</source>
        <translation>Mitte (%1)</translation>
    </message>
    <message>
        <source>Centre of mass. %1</source>
        <translation>Schwerpunkt. %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ComponentsPanel</name>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>any area</source>
        <translation>jede Fläche</translation>
    </message>
    <message>
        <source>&amp;Smaller than</source>
        <translation>&amp;Kleiner als</translation>
    </message>
    <message>
        <source>Components, largest first</source>
        <translation>Teile, die größten zuerst</translation>
    </message>
    <message>
        <source>Click a component, or press Return on it, to bring it into sight</source>
        <translation>Klick auf einen Teil oder Eingabe darauf bringt ihn ins Bild</translation>
    </message>
    <message>
        <source>Number and area of the components that are shown</source>
        <translation>Anzahl und Fläche der gezeigten Teile</translation>
    </message>
    <message>
        <source>Copy all rows that are shown to the clipboard, with tabs for a spreadsheet</source>
        <translation>Alle gezeigten Zeilen in die Zwischenablage kopieren, mit Tabulatoren für eine Tabelle</translation>
    </message>
    <message>
        <source>No result yet</source>
        <translation>Noch kein Ergebnis</translation>
    </message>
    <message>
        <source>%1 components, %2</source>
        <translation>%1 Teile, %2</translation>
    </message>
    <message>
        <source>%1 of %2 components, %3</source>
        <translation>%1 von %2 Teilen, %3</translation>
    </message>
    <message>
        <source>Show only components with less area than this, in %1</source>
        <translation>Nur Teile mit weniger Fläche zeigen, in %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no area; give a number above 0, such as %2</source>
        <translation>„%1“ ist keine Fläche; geben Sie eine Zahl über 0 an, etwa %2</translation>
    </message>
    <message>
        <source>%1 of 1 component, %2</source>
        <translation>%1 von 1 Teil, %2</translation>
    </message>
    <message>
        <source>1 component, %1</source>
        <translation>1 Teil, %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CorridorWatch</name>
    <message>
        <source>The corridors: memory ran out; close other programs or use a smaller environment</source>
        <translation>Die Korridore: Der Speicher reicht nicht; schließen Sie andere Programme oder verwenden Sie eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CorridorsFeature</name>
    <message>
        <source>Corridors</source>
        <translation>Korridore</translation>
    </message>
    <message>
        <source>Show how wide every passage is, and list the bottlenecks</source>
        <translation>Zeigt, wie breit jeder Durchgang ist, und listet die Engstellen auf</translation>
    </message>
    <message>
        <source>Open an environment first.</source>
        <translation>Öffnen Sie zuerst eine Umgebung.</translation>
    </message>
    <message>
        <source>Making the corridor map …</source>
        <translation>Die Korridorkarte wird berechnet …</translation>
    </message>
    <message>
        <source>The corridors follow when a run has finished.</source>
        <translation>Die Korridore folgen, wenn ein Lauf fertig ist.</translation>
    </message>
    <message>
        <source>%1, too narrow</source>
        <translation>%1, zu schmal</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CorridorsPanel</name>
    <message>
        <source>Show the &amp;map</source>
        <translation>&amp;Karte zeigen</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Width of an agent</source>
        <translation>Breite eines Agenten</translation>
    </message>
    <message>
        <source>Width of an agent; narrower passages are too narrow for it</source>
        <translation>Breite eines Agenten; schmalere Durchgänge sind für ihn zu schmal</translation>
    </message>
    <message>
        <source>&amp;Agent&apos;s width</source>
        <translation>Breite des &amp;Agenten</translation>
    </message>
    <message>
        <source>Draw the middle lines of all passages in the colours of their widths</source>
        <translation>Zeichnet die Mittellinien aller Durchgänge in den Farben ihrer Breiten</translation>
    </message>
    <message>
        <source>Colours of the map, narrow to wide</source>
        <translation>Farben der Karte, von schmal nach breit</translation>
    </message>
    <message>
        <source>Bottlenecks, narrowest first</source>
        <translation>Engstellen, die schmalste zuerst</translation>
    </message>
    <message>
        <source>Click a bottleneck, or press Return on it, to bring it into sight</source>
        <translation>Eine Engstelle anklicken oder auf ihr die Eingabetaste drücken, um sie ins Bild zu holen</translation>
    </message>
    <message>
        <source>Copy the list to the clipboard, with tabs for a spreadsheet</source>
        <translation>Kopiert die Liste in die Zwischenablage, mit Tabulatoren für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>wider</source>
        <translation>breiter</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>No bottlenecks</source>
        <translation>Keine Engstellen</translation>
    </message>
    <message numerus="yes">
        <source>%n slits of at most %1 are left out.</source>
        <translation>
            <numerusform>%n Schlitz von höchstens %1 ist weggelassen.</numerusform>
            <numerusform>%n Schlitze von höchstens %1 sind weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n places are left out from which the way gets wider by less than %1 %.</source>
        <translation>
            <numerusform>%n Stelle ist weggelassen, hinter der der Weg um weniger als %1 % breiter wird.</numerusform>
            <numerusform>%n Stellen sind weggelassen, hinter denen der Weg um weniger als %1 % breiter wird.</numerusform>
        </translation>
    </message>
    <message>
        <source>Measured without the filter Radius, which makes passages narrower.</source>
        <translation>Gemessen ohne den Filter Radius, der Durchgänge schmaler macht.</translation>
    </message>
    <message numerus="yes">
        <source>The widest %n pieces of the map are not drawn.</source>
        <translation>
            <numerusform>Das breiteste Stück der Karte ist nicht gezeichnet.</numerusform>
            <numerusform>Die %n breitesten Stücke der Karte sind nicht gezeichnet.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Only those without another way</source>
        <translation>&amp;Nur solche ohne anderen Weg</translation>
    </message>
    <message>
        <source>List only bottlenecks that everybody must pass to get from one side to the other</source>
        <translation>Listet nur Engstellen auf, durch die jeder muss, um von der einen Seite zur anderen zu kommen</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>bottleneck</source>
        <translation>Engstelle</translation>
    </message>
    <message>
        <source>bottlenecks</source>
        <translation>Engstellen</translation>
    </message>
    <message>
        <source>, %1 too narrow for the agent</source>
        <translation>, %1 zu schmal für den Agenten</translation>
    </message>
</context>
<context>
    <name>footfall::ui::CutBar</name>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Direction of the cut plane</source>
        <translation>Richtung der Schnittebene</translation>
    </message>
    <message>
        <source>Which way the plane faces</source>
        <translation>Wohin die Ebene zeigt</translation>
    </message>
    <message>
        <source>Facing the camera</source>
        <translation>Der Kamera zugewandt</translation>
    </message>
    <message>
        <source>Position of the cut plane</source>
        <translation>Lage der Schnittebene</translation>
    </message>
    <message>
        <source>Move the plane through the level</source>
        <translation>Die Ebene durch das Level bewegen</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Show what is on the other side of the plane</source>
        <translation>Zeigen, was auf der anderen Seite der Ebene liegt</translation>
    </message>
    <message>
        <source>No cut plane</source>
        <translation>Keine Schnittebene</translation>
    </message>
    <message>
        <source>Show the whole level again</source>
        <translation>Wieder das ganze Level zeigen</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Quer zu %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::Document</name>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>%1 nach unten</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Run in parallel</source>
        <translation>Parallel ausführen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::DrawingNote</name>
    <message>
        <source>Drawing the result</source>
        <translation>Das Ergebnis wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>footfall::ui::EditorWindow</name>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Filters</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
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
        <source>&amp;Pipeline</source>
        <translation>&amp;Pipeline</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Öffnen...</translation>
    </message>
    <message>
        <source>Open an environment or a session</source>
        <translation>Eine Umgebung oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Open pipeline...</source>
        <translation>Pipeline &amp;öffnen...</translation>
    </message>
    <message>
        <source>&amp;Save pipeline...</source>
        <translation>Pipeline &amp;speichern...</translation>
    </message>
    <message>
        <source>Use &amp;default filters</source>
        <translation>&amp;Vorgegebene Filter verwenden</translation>
    </message>
    <message>
        <source>&amp;Run again</source>
        <translation>&amp;Erneut ausführen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>From the &amp;top</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>Look straight down, as on a plan</source>
        <translation>Senkrecht nach unten sehen, wie auf einem Plan</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Schräg</translation>
    </message>
    <message>
        <source>Look from above at an angle</source>
        <translation>Schräg von oben sehen</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Bring everything into sight</source>
        <translation>Alles ins Bild bringen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Vergrößern</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>All keys, and what the mouse does in the view</source>
        <translation>Alle Tasten, und was die Maus in der Ansicht tut</translation>
    </message>
    <message>
        <source>&amp;About Footfall</source>
        <translation>&amp;Über Footfall</translation>
    </message>
    <message>
        <source>About Footfall</source>
        <translation>Über Footfall</translation>
    </message>
    <message>
        <source>&lt;b&gt;Footfall %1&lt;/b&gt;&lt;p&gt;The exact walkable area of 3D environments.&lt;/p&gt;&lt;p&gt;Free software under the GNU GPL, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Footfall %1&lt;/b&gt;&lt;p&gt;Die exakte begehbare Fläche von 3D-Umgebungen.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU GPL, Version 3 oder später.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Describes the filter that has the focus</source>
        <translation>Beschreibt den Filter, der den Fokus hat</translation>
    </message>
    <message>
        <source>&amp;Reset window layout</source>
        <translation>&amp;Fensteraufteilung zurücksetzen</translation>
    </message>
    <message>
        <source>Move all panels and tool bars back to their default places</source>
        <translation>Alle Tafeln und Leisten an ihre vorgegebenen Plätze zurückstellen</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>&amp;Befehl suchen...</translation>
    </message>
    <message>
        <source>Find any command by a few letters</source>
        <translation>Jeden Befehl mit wenigen Buchstaben finden</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>Loading cancelled</source>
        <translation>Laden abgebrochen</translation>
    </message>
    <message>
        <source>Cancelled; the view shows the previous result. Press F5 to run again.</source>
        <translation>Abgebrochen; die Ansicht zeigt das vorige Ergebnis. F5 startet erneut.</translation>
    </message>
    <message>
        <source>The run failed; the view shows the previous result</source>
        <translation>Der Lauf ist fehlgeschlagen; die Ansicht zeigt das vorige Ergebnis</translation>
    </message>
    <message>
        <source>no environment</source>
        <translation>keine Umgebung</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>Write the walkable area, a picture or a report</source>
        <translation>Die begehbare Fläche, ein Bild oder einen Bericht schreiben</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>&amp;Agents</source>
        <translation>&amp;Agenten</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Display &amp;mode</source>
        <translation>&amp;Darstellung</translation>
    </message>
    <message>
        <source>&amp;Floors and cuts</source>
        <translation>&amp;Böden und Schnitte</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Tafeln</translation>
    </message>
    <message>
        <source>Selected &amp;filters</source>
        <translation>Ausgewählte &amp;Filter</translation>
    </message>
    <message>
        <source>T&amp;hreads</source>
        <translation>T&amp;hreads</translation>
    </message>
    <message>
        <source>&amp;Environment</source>
        <translation>&amp;Umgebung</translation>
    </message>
    <message>
        <source>What was opened: its extent, axes and scale</source>
        <translation>Was geöffnet ist: Ausdehnung, Achsen und Maßstab</translation>
    </message>
    <message>
        <source>&amp;Filters</source>
        <translation>&amp;Filter</translation>
    </message>
    <message>
        <source>The steps that make the walkable area</source>
        <translation>Die Schritte, aus denen die begehbare Fläche entsteht</translation>
    </message>
    <message>
        <source>%1. Not written: %2</source>
        <translation>%1. Nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Show the window on the whole screen, or leave full screen</source>
        <translation>Das Fenster auf dem ganzen Bildschirm zeigen oder das Vollbild verlassen</translation>
    </message>
    <message>
        <source>Stop loading, running or exporting; the last result stays (Esc)</source>
        <translation>Laden, Lauf oder Export anhalten; das letzte Ergebnis bleibt (Esc)</translation>
    </message>
    <message>
        <source>Run o&amp;n</source>
        <translation>Rechnen a&amp;uf</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Sitzung &amp;speichern</translation>
    </message>
    <message>
        <source>Save environment, filters and view to the session&apos;s file</source>
        <translation>Umgebung, Filter und Ansicht in die Datei der Sitzung speichern</translation>
    </message>
    <message>
        <source>Save session &amp;as...</source>
        <translation>Sitzung speichern un&amp;ter...</translation>
    </message>
    <message>
        <source>Save environment, filters and view to another file</source>
        <translation>Umgebung, Filter und Ansicht in eine andere Datei speichern</translation>
    </message>
    <message>
        <source>Copy s&amp;creenshot</source>
        <translation>Bildschirm&amp;foto kopieren</translation>
    </message>
    <message>
        <source>Copy what the view shows as a picture, without panels</source>
        <translation>Was die Ansicht zeigt, als Bild kopieren, ohne Tafeln</translation>
    </message>
    <message>
        <source>Copied a picture of the view</source>
        <translation>Ein Bild der Ansicht ist kopiert</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Units, threads, theme, language, size of the interface, and keys</source>
        <translation>Einheiten, Threads, Darstellung, Sprache, Größe der Oberfläche und Tasten</translation>
    </message>
    <message>
        <source>Turntable: %1 of %2 frames</source>
        <translation>Drehteller: %1 von %2 Bildern</translation>
    </message>
</context>
<context>
    <name>footfall::ui::EnvironmentLoader</name>
    <message>
        <source>%1: memory ran out; close other programs or use a smaller environment</source>
        <translation>%1: Der Speicher reicht nicht; schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::EnvironmentTools</name>
    <message>
        <source>Meshes and Materials</source>
        <translation>Netze und Materialien</translation>
    </message>
    <message>
        <source>Leave parts of the environment out, or make them obstacles that nobody walks on</source>
        <translation>Teile der Umgebung weglassen oder zu Hindernissen machen, auf denen niemand geht</translation>
    </message>
    <message>
        <source>%1 was deleted; the result stays, and the file is read again once it exists</source>
        <translation>%1 wurde gelöscht; das Ergebnis bleibt, und die Datei wird gelesen, sobald es sie wieder gibt</translation>
    </message>
    <message>
        <source>%1 changed on disk, but %2; the earlier version stays loaded</source>
        <translation>%1 hat sich auf der Platte geändert, aber %2; die frühere Fassung bleibt geladen</translation>
    </message>
    <message>
        <source>%1 changed on disk; read again</source>
        <translation>%1 hat sich auf der Platte geändert; neu gelesen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>The file to write; its ending chooses the format</source>
        <translation>Die zu schreibende Datei; ihre Endung wählt das Format</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen...</translation>
    </message>
    <message>
        <source>Choose the file in a dialog</source>
        <translation>Die Datei in einem Dialog wählen</translation>
    </message>
    <message>
        <source>Connections as lines</source>
        <translation>Verbindungen als Linien</translation>
    </message>
    <message>
        <source>The edges on which two layers meet</source>
        <translation>Die Kanten, an denen sich zwei Ebenen treffen</translation>
    </message>
    <message>
        <source>Obstacle edges as lines</source>
        <translation>Hinderniskanten als Linien</translation>
    </message>
    <message>
        <source>Edges that agents cannot cross though both sides are walkable</source>
        <translation>Kanten, die Agenten nicht überqueren können, obwohl beide Seiten begehbar sind</translation>
    </message>
    <message>
        <source>Placed obstacles</source>
        <translation>Gesetzte Hindernisse</translation>
    </message>
    <message>
        <source>Each obstacle that was placed in the editor, as a group of its own</source>
        <translation>Jedes im Editor gesetzte Hindernis, als eigene Gruppe</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Larger pictures have thicker lines, so that they look the same</source>
        <translation>Größere Bilder haben dickere Linien, damit sie gleich aussehen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Pictures: as seen now, from the top, and oblique</source>
        <translation>Bilder: wie jetzt zu sehen, von oben und schräg</translation>
    </message>
    <message>
        <source>They are part of the file</source>
        <translation>Sie sind Teil der Datei</translation>
    </message>
    <message>
        <source>Bottlenecks: the narrowest passages</source>
        <translation>Engstellen: die schmalsten Durchgänge</translation>
    </message>
    <message>
        <source>Their corridor map takes a while on large levels</source>
        <translation>Ihre Korridorkarte braucht in großen Leveln eine Weile</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Give a name for the file.</source>
        <translation>Geben Sie der Datei einen Namen.</translation>
    </message>
    <message>
        <source>%1 is a folder; give the name of a file in it.</source>
        <translation>%1 ist ein Ordner; geben Sie den Namen einer Datei darin.</translation>
    </message>
    <message>
        <source>Scale: %1</source>
        <translation>Maßstab: %1</translation>
    </message>
    <message>
        <source>The view as it is now, with what tools have drawn, without panels.</source>
        <translation>Die Ansicht, wie sie jetzt ist, mit dem, was Werkzeuge gezeichnet haben, ohne Tafeln.</translation>
    </message>
    <message>
        <source>The result of the run under way.</source>
        <translation>Das Ergebnis des Laufs, der gerade läuft.</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>step with its times</source>
        <translation>Schritt mit seinen Zeiten</translation>
    </message>
    <message>
        <source>steps with their times</source>
        <translation>Schritte mit ihren Zeiten</translation>
    </message>
    <message>
        <source>three pictures</source>
        <translation>drei Bilder</translation>
    </message>
    <message>
        <source>bottlenecks</source>
        <translation>Engstellen</translation>
    </message>
    <message>
        <source>Figures of a result with %1.</source>
        <translation>Zahlen eines Ergebnisses mit %1.</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>obstacle edge</source>
        <translation>Hinderniskante</translation>
    </message>
    <message>
        <source>obstacle edges</source>
        <translation>Hinderniskanten</translation>
    </message>
    <message>
        <source>placed obstacle</source>
        <translation>gesetztes Hindernis</translation>
    </message>
    <message>
        <source>placed obstacles</source>
        <translation>gesetzte Hindernisse</translation>
    </message>
    <message>
        <source>The export waits for the run under way.</source>
        <translation>Der Export wartet auf den laufenden Lauf.</translation>
    </message>
    <message>
        <source>Size: ...</source>
        <translation>Größe: ...</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Größe: %1</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 oben</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Drops as lines</source>
        <translation>Sprünge als Linien</translation>
    </message>
    <message>
        <source>Lines from where an agent drops to where it lands</source>
        <translation>Linien von der Absprungstelle zur Landestelle</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>drop</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>drops</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Coordinates are multiplied with it. 1 keeps the file&apos;s units (metres in all formats but OBJ), and OBJ exact; other scales than powers of two round once more.</source>
        <translation>Koordinaten werden damit multipliziert. 1 behält die Einheiten der Datei (Meter in allen Formaten außer OBJ) und OBJ exakt; andere Maßstäbe als Zweierpotenzen runden noch einmal.</translation>
    </message>
    <message>
        <source>&quot;.%1&quot; is no format that can be written; the name must end in one of %2.</source>
        <translation>„.%1“ ist kein Format, das geschrieben werden kann; der Name muss auf eines von %2 enden.</translation>
    </message>
    <message>
        <source>The format has floats: coordinates move by up to %1 m</source>
        <translation>Das Format hat einfache Genauigkeit: Koordinaten bewegen sich um bis zu %1 m</translation>
    </message>
    <message>
        <source>What the file is for; options are remembered for each of them</source>
        <translation>Wofür die Datei ist; die Einstellungen werden für jedes Ziel gemerkt</translation>
    </message>
    <message>
        <source>Which axis points up in an OBJ; other formats have one</source>
        <translation>Welche Achse in einer OBJ nach oben zeigt; andere Formate haben eine feste</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>One connected part alone, by its number in the panel Components; 1 is the largest</source>
        <translation>Nur ein zusammenhängender Teil, nach seiner Nummer in der Tafel Teile; 1 ist der größte</translation>
    </message>
    <message>
        <source>The coordinate system that GeoJSON is to name, where the environment is in one; nothing is moved</source>
        <translation>Das Koordinatensystem, das GeoJSON nennen soll, wo die Umgebung in einem liegt; nichts wird verschoben</translation>
    </message>
    <message>
        <source>Connected part</source>
        <translation>Zusammenhängender Teil</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Für</translation>
    </message>
    <message>
        <source>Keeps</source>
        <translation>Behält</translation>
    </message>
    <message>
        <source>Loses</source>
        <translation>Verliert</translation>
    </message>
    <message>
        <source>This program was built without Detour and cannot write .bin; choose another target.</source>
        <translation>Dieses Programm wurde ohne Detour gebaut und kann kein .bin schreiben; wählen Sie ein anderes Ziel.</translation>
    </message>
    <message>
        <source>Polygons.</source>
        <translation>Polygone.</translation>
    </message>
    <message>
        <source>%1 files, the first is %2</source>
        <translation>%1 Dateien, die erste ist %2</translation>
    </message>
    <message>
        <source>Off: the whole walkable area as one</source>
        <translation>Aus: die ganze begehbare Fläche zusammen</translation>
    </message>
    <message>
        <source>Off: the file has no steps; floors that only steps join are separate</source>
        <translation>Aus: ohne Stufen; Böden, die nur Stufen verbinden, sind in der Datei getrennt</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ExportTexts</name>
    <message>
        <source>As on the screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice that</source>
        <translation>Doppelt so groß</translation>
    </message>
    <message>
        <source>Four times that</source>
        <translation>Viermal so groß</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K, 3840 × 2160</translation>
    </message>
    <message>
        <source>Any program: OBJ, exact</source>
        <translation>Jedes Programm: OBJ, exakt</translation>
    </message>
    <message>
        <source>Unreal, Unity and other engines: glTF</source>
        <translation>Unreal, Unity und andere Engines: glTF</translation>
    </message>
    <message>
        <source>Godot 4: navigation mesh</source>
        <translation>Godot 4: Navigationsnetz</translation>
    </message>
    <message>
        <source>Godot 3: navigation mesh</source>
        <translation>Godot 3: Navigationsnetz</translation>
    </message>
    <message>
        <source>Godot: glTF scene with a navigation region</source>
        <translation>Godot: glTF-Szene mit einer Navigationsregion</translation>
    </message>
    <message>
        <source>Recast and Detour: tile set</source>
        <translation>Recast und Detour: Kachelsatz</translation>
    </message>
    <message>
        <source>Blender: glTF</source>
        <translation>Blender: glTF</translation>
    </message>
    <message>
        <source>Browsers and scripts: glTF as text</source>
        <translation>Browser und Skripte: glTF als Text</translation>
    </message>
    <message>
        <source>JuPedSim and other simulators: polygons</source>
        <translation>JuPedSim und andere Simulatoren: Polygone</translation>
    </message>
    <message>
        <source>Geographic programs: GeoJSON</source>
        <translation>Geografische Programme: GeoJSON</translation>
    </message>
    <message>
        <source>Printers: floor plan</source>
        <translation>Drucker: Grundriss</translation>
    </message>
    <message>
        <source>Drawing programs: floor plan</source>
        <translation>Zeichenprogramme: Grundriss</translation>
    </message>
    <message>
        <source>People: a picture of the view</source>
        <translation>Menschen: ein Bild der Ansicht</translation>
    </message>
    <message>
        <source>People: a report with figures and pictures</source>
        <translation>Menschen: ein Bericht mit Zahlen und Bildern</translation>
    </message>
</context>
<context>
    <name>footfall::ui::FileWriter</name>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
</context>
<context>
    <name>footfall::ui::FilterActions</name>
    <message>
        <source>Parallel blocks</source>
        <translation>Parallele Blöcke</translation>
    </message>
    <message>
        <source>Cu&amp;t filters</source>
        <translation>Filter &amp;ausschneiden</translation>
    </message>
    <message>
        <source>Take the selected filters out, as text for the clipboard</source>
        <translation>Die ausgewählten Filter herausnehmen, als Text für die Zwischenablage</translation>
    </message>
    <message>
        <source>&amp;Copy filters</source>
        <translation>Filter &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the selected filters, as lines of a pipeline file</source>
        <translation>Die ausgewählten Filter kopieren, als Zeilen einer Pipeline-Datei</translation>
    </message>
    <message>
        <source>&amp;Paste filters</source>
        <translation>Filter &amp;einfügen</translation>
    </message>
    <message>
        <source>Put filters from the clipboard behind the selected ones</source>
        <translation>Filter aus der Zwischenablage hinter die ausgewählten setzen</translation>
    </message>
    <message>
        <source>&amp;Duplicate filters</source>
        <translation>Filter &amp;verdoppeln</translation>
    </message>
    <message>
        <source>Put copies behind the selected filters</source>
        <translation>Kopien hinter die ausgewählten Filter setzen</translation>
    </message>
    <message>
        <source>&amp;Remove filters</source>
        <translation>Filter entfe&amp;rnen</translation>
    </message>
    <message>
        <source>Remove the selected filters</source>
        <translation>Die ausgewählten Filter entfernen</translation>
    </message>
    <message>
        <source>Select &amp;all filters</source>
        <translation>A&amp;lle Filter auswählen</translation>
    </message>
    <message>
        <source>Select all rows</source>
        <translation>Alle Zeilen auswählen</translation>
    </message>
    <message>
        <source>Move filters &amp;up</source>
        <translation>Filter nach &amp;oben</translation>
    </message>
    <message>
        <source>Move the selected filters up by one row</source>
        <translation>Die ausgewählten Filter eine Zeile nach oben</translation>
    </message>
    <message>
        <source>Move filters do&amp;wn</source>
        <translation>Filter nach &amp;unten</translation>
    </message>
    <message>
        <source>Move the selected filters down by one row</source>
        <translation>Die ausgewählten Filter eine Zeile nach unten</translation>
    </message>
    <message>
        <source>&amp;Switch filters on or off</source>
        <translation>Filter ein- oder au&amp;sschalten</translation>
    </message>
    <message>
        <source>Switch the selected filters off, or on again</source>
        <translation>Die ausgewählten Filter aus- oder wieder einschalten</translation>
    </message>
    <message>
        <source>Run &amp;only up to here</source>
        <translation>&amp;Nur bis hier ausführen</translation>
    </message>
    <message>
        <source>Switch off all filters behind the selected one</source>
        <translation>Alle Filter hinter dem ausgewählten ausschalten</translation>
    </message>
    <message>
        <source>Switch all ot&amp;hers off</source>
        <translation>Alle an&amp;deren ausschalten</translation>
    </message>
    <message>
        <source>Leave only the selected filters on</source>
        <translation>Nur die ausgewählten Filter anlassen</translation>
    </message>
    <message>
        <source>Switch all o&amp;n</source>
        <translation>Alle e&amp;inschalten</translation>
    </message>
    <message>
        <source>Switch all filters on</source>
        <translation>Alle Filter einschalten</translation>
    </message>
    <message>
        <source>Use de&amp;fault values</source>
        <translation>Vor&amp;gaben verwenden</translation>
    </message>
    <message>
        <source>Give the selected filters the values of new ones</source>
        <translation>Den ausgewählten Filtern die Werte neuer geben</translation>
    </message>
    <message>
        <source>&amp;Insert behind</source>
        <translation>&amp;Dahinter einfügen</translation>
    </message>
    <message>
        <source>Insert &amp;before</source>
        <translation>Da&amp;vor einfügen</translation>
    </message>
    <message>
        <source>Insert %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>clipboard: holds no filters; copy lines of a pipeline first</source>
        <translation>Zwischenablage: enthält keine Filter; kopieren Sie zuerst Zeilen einer Pipeline</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Use default values of %1</source>
        <translation>Vorgaben von %1 verwenden</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>footfall::ui::FilterHelp</name>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>a length in the environment&apos;s units</source>
        <translation>eine Länge in den Einheiten der Umgebung</translation>
    </message>
    <message>
        <source>an area in the environment&apos;s units</source>
        <translation>eine Fläche in den Einheiten der Umgebung</translation>
    </message>
    <message>
        <source>on or off</source>
        <translation>an oder aus</translation>
    </message>
    <message>
        <source>a whole number above %1</source>
        <translation>eine ganze Zahl über %1</translation>
    </message>
    <message>
        <source>a number above %1</source>
        <translation>eine Zahl über %1</translation>
    </message>
    <message>
        <source>a whole number from %1</source>
        <translation>eine ganze Zahl ab %1</translation>
    </message>
    <message>
        <source>a number from %1</source>
        <translation>eine Zahl ab %1</translation>
    </message>
    <message>
        <source>to below %1</source>
        <translation>bis unter %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Takes %1. Default: %2.</source>
        <translation>Nimmt %1. Vorgabe: %2.</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>Braucht</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Wirkung</translation>
    </message>
    <message>
        <source>Partitioning</source>
        <translation>Aufteilung</translation>
    </message>
    <message>
        <source>Local: may stand inside a parallel block</source>
        <translation>Lokal: darf in einem parallelen Block stehen</translation>
    </message>
    <message>
        <source>Global: may not stand inside a parallel block</source>
        <translation>Global: darf nicht in einem parallelen Block stehen</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>In pipeline files</source>
        <translation>In Pipeline-Dateien</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Takes %1.</source>
        <translation>Nimmt %1.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::FilterList</name>
    <message>
        <source>No filters: everything that faces up is walkable. Add one above.</source>
        <translation>Keine Filter: Alles, was nach oben zeigt, ist begehbar. Fügen Sie oben einen hinzu.</translation>
    </message>
    <message>
        <source>+ Add filter</source>
        <translation>+ Filter hinzufügen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Load a saved pipeline, or save this one</source>
        <translation>Eine gespeicherte Pipeline laden oder diese speichern</translation>
    </message>
    <message>
        <source>Run automatically</source>
        <translation>Selbsttätig ausführen</translation>
    </message>
    <message>
        <source>On: every edit starts a run; if runs take long, the run starts when you pause. Off: press F5 to run.</source>
        <translation>An: Jede Änderung startet einen Lauf; dauern Läufe lange, beginnt er, wenn Sie innehalten. Aus: F5 startet den Lauf.</translation>
    </message>
    <message>
        <source>Add a filter behind the selected one, or at the end of the list</source>
        <translation>Einen Filter hinter dem ausgewählten oder am Ende der Liste hinzufügen</translation>
    </message>
    <message>
        <source>Behind %1</source>
        <translation>Hinter %1</translation>
    </message>
    <message>
        <source>At the end of the list</source>
        <translation>Am Ende der Liste</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::FilterRow</name>
    <message>
        <source>&lt;p&gt;Type it, drag sideways, or turn the wheel while the field has the focus; Shift: finer, Ctrl: coarser, Esc: back.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Tippen, seitwärts ziehen oder das Rad drehen, während das Feld den Fokus hat; Umschalt: feiner, Strg: gröber, Esc: zurück.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>%1 → %2 triangles</source>
        <translation>%1 → %2 Dreiecke</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>Drag to change the order (or Alt+Up, Alt+Down)</source>
        <translation>Ziehen ändert die Reihenfolge (auch Alt+Auf, Alt+Ab)</translation>
    </message>
    <message>
        <source>Remove this filter</source>
        <translation>Diesen Filter entfernen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Preview the cells that this strategy makes, without running the filters</source>
        <translation>Die Zellen dieser Strategie vorab zeigen, ohne die Filter auszuführen</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;i&gt;Needs:&lt;/i&gt; %1&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;i&gt;Braucht:&lt;/i&gt; %1&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;i&gt;Effect:&lt;/i&gt; %1&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;i&gt;Wirkung:&lt;/i&gt; %1&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Takes %1. Default: %2%3.</source>
        <translation>Nimmt %1. Vorgabe: %2%3.</translation>
    </message>
    <message>
        <source>%1 → 1 triangle</source>
        <translation>%1 → 1 Dreieck</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 Dreieck</translation>
    </message>
    <message>
        <source>Takes %1.</source>
        <translation>Nimmt %1.</translation>
    </message>
    <message>
        <source>Remove seed %1</source>
        <translation>Startpunkt %1 entfernen</translation>
    </message>
    <message>
        <source>%1 of seed %2</source>
        <translation>%1 von Startpunkt %2</translation>
    </message>
    <message>
        <source>Place seeds</source>
        <translation>Startpunkte setzen</translation>
    </message>
    <message>
        <source>Click the places in the view where agents start; everything that they cannot reach is removed</source>
        <translation>Klicken Sie in der Ansicht auf die Stellen, an denen Agenten beginnen; was sie nicht erreichen, wird entfernt</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und noch %1</translation>
    </message>
    <message>
        <source>Switch this filter off and on (Space)</source>
        <translation>Diesen Filter aus- und einschalten (Leertaste)</translation>
    </message>
    <message numerus="yes">
        <source>%n seeds</source>
        <translation>
            <numerusform>%n Startpunkt</numerusform>
            <numerusform>%n Startpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>needs %1</source>
        <translation>braucht: %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::FlyTool</name>
    <message>
        <source>Fly: W A S D move, Q and E down and up, the mouse looks, Shift faster, the wheel changes the speed (%1 units a second), Esc ends</source>
        <translation>Fliegen: W A S D bewegen, Q und E ab und auf, die Maus sieht sich um, Umschalt schneller, das Rad ändert das Tempo (%1 Einheiten je Sekunde), Esc beendet</translation>
    </message>
</context>
<context>
    <name>footfall::ui::GuardedApplication</name>
    <message>
        <source>an unknown error occurred; save your session under another name and restart Footfall</source>
        <translation>Ein unbekannter Fehler ist aufgetreten; speichern Sie die Sitzung unter anderem Namen und starten Sie Footfall neu</translation>
    </message>
    <message>
        <source>memory ran out; nothing was lost. Close other programs, or open a smaller environment</source>
        <translation>Der Speicher reicht nicht; nichts ging verloren. Schließen Sie andere Programme oder öffnen Sie eine kleinere Umgebung</translation>
    </message>
    <message>
        <source>internal error (%1); please report it with what you did</source>
        <translation>Interner Fehler (%1); bitte melden Sie ihn mit dem, was Sie getan haben</translation>
    </message>
</context>
<context>
    <name>footfall::ui::HeightSlider</name>
    <message>
        <source>Heights that are shown</source>
        <translation>Gezeigte Höhen</translation>
    </message>
    <message>
        <source>Hide everything that is higher or lower, to look under roofs. The result does not change.
Handles snap to floors, except while Alt is held; a double click shows everything again.</source>
        <translation>Ausblenden, was höher oder tiefer liegt, um unter Dächer zu sehen. Das Ergebnis ändert sich nicht.
Die Griffe rasten an Böden ein, außer mit gedrückter Alt-Taste; ein Doppelklick zeigt wieder alles.</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
    <message>
        <source>Height, %1</source>
        <translation>Höhe, %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::HelpPanel</name>
    <message>
        <source>Help about the filter that has the focus</source>
        <translation>Hilfe zum Filter, der den Fokus hat</translation>
    </message>
    <message>
        <source>&lt;p&gt;Click on a filter, or go to it with Tab: this tells what it does, what its values mean and what it needs.&lt;/p&gt;&lt;p&gt;F1 lists all keys. Ctrl+K finds every command by a few letters.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Klicken Sie auf einen Filter, oder gehen Sie mit Tab hin: Hier steht, was er tut, was seine Werte bedeuten und was er braucht.&lt;/p&gt;&lt;p&gt;F1 zeigt alle Tasten. Strg+K findet jeden Befehl mit wenigen Buchstaben.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>footfall::ui::HistogramPlot</name>
    <message>
        <source>How many cells took how long</source>
        <translation>Wie viele Zellen wie lange dauerten</translation>
    </message>
    <message>
        <source>time of a cell</source>
        <translation>Zeit einer Zelle</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s): median %1, longest %2 (cell %3)</source>
        <translation>
            <numerusform>%n Zelle: Median %1, längste %2 (Zelle %3)</numerusform>
            <numerusform>%n Zellen: Median %1, längste %2 (Zelle %3)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) took %1 to %2</source>
        <translation>
            <numerusform>%n Zelle dauerte %1 bis %2</numerusform>
            <numerusform>%n Zellen dauerten %1 bis %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::ImportEdits</name>
    <message>
        <source>Change import options</source>
        <translation>Importoptionen ändern</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ImportPanel</name>
    <message>
        <source>Nothing loaded</source>
        <translation>Nichts geladen</translation>
    </message>
    <message>
        <source>Open a file (Ctrl+O), or drop one here.</source>
        <translation>Öffnen Sie eine Datei (Strg+O), oder lassen Sie eine hier fallen.</translation>
    </message>
    <message>
        <source>Guess</source>
        <translation>Raten</translation>
    </message>
    <message>
        <source>Both sides count as up</source>
        <translation>Beide Seiten zählen als oben</translation>
    </message>
    <message>
        <source>For files whose triangles face the wrong way: triangles that face down also count as facing up.</source>
        <translation>Für Dateien, deren Dreiecke falsch herum liegen: Was nach unten zeigt, gilt als nach oben zeigend.</translation>
    </message>
    <message>
        <source>Watch the file</source>
        <translation>Datei beobachten</translation>
    </message>
    <message>
        <source>Reads the file again when another program has saved it. Camera, filters, roles and obstacles stay, and only what differs is computed again.</source>
        <translation>Liest die Datei neu, wenn ein anderes Programm sie gespeichert hat. Kamera, Filter, Rollen und Hindernisse bleiben, und nur was sich unterscheidet, wird neu berechnet.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Metres per unit</source>
        <translation>Meter je Einheit</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>Grid of %1, moved by at most %2</source>
        <translation>Raster von %1, um höchstens %2 verschoben</translation>
    </message>
    <message>
        <source>welded vertices: %1</source>
        <translation>verschweißte Ecken: %1</translation>
    </message>
    <message>
        <source>Rounds coordinates to a fine grid. Automatic: for files that store floats, such as glTF and FBX; what should lie in one plane then does.</source>
        <translation>Rundet Koordinaten auf ein feines Raster. Automatisch: bei Dateien mit Gleitkommazahlen einfacher Genauigkeit, wie glTF und FBX; was in einer Ebene liegen soll, liegt dann in ihr.</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Skipped: %1</source>
        <translation>Ausgelassen: %1</translation>
    </message>
    <message>
        <source>(guessed)</source>
        <translation>(geraten)</translation>
    </message>
    <message>
        <source>Which axis of the file points up; places are shown along the axes of the file</source>
        <translation>Welche Achse der Datei nach oben zeigt; Orte werden entlang der Achsen der Datei angegeben</translation>
    </message>
    <message>
        <source>How many metres one unit of the file is. Coordinates are never scaled: lengths are shown and typed in metres, and filters that still have their defaults follow.</source>
        <translation>Wie viele Meter eine Einheit der Datei ist. Koordinaten werden nie umgerechnet: Längen werden in Metern gezeigt und eingegeben, und Filter mit unveränderten Vorgaben folgen.</translation>
    </message>
    <message>
        <source>The file does not state its unit. Once the scale is known, all lengths are shown and typed in metres (or in the unit of View &gt; Lengths in).</source>
        <translation>Die Datei sagt nicht, was ihre Einheit ist. Ist der Maßstab bekannt, werden alle Längen in Metern gezeigt und eingegeben (oder wie unter Ansicht &gt; Längen in gewählt).</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>%1 (guessed)</source>
        <translation>%1 (geraten)</translation>
    </message>
    <message>
        <source>1 unit of the file is %1</source>
        <translation>1 Einheit der Datei ist %1</translation>
    </message>
    <message>
        <source>No, %1</source>
        <translation>Nein, %1</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 %4 (%5)</source>
        <translation>%1 × %2 × %3 %4 (%5)</translation>
    </message>
    <message>
        <source>Part: %1 of %2 triangles</source>
        <translation>Teil: %1 von %2 Dreiecken</translation>
    </message>
    <message>
        <source>%1 (from the file)</source>
        <translation>%1 (aus der Datei)</translation>
    </message>
    <message>
        <source>(from the file)</source>
        <translation>(aus der Datei)</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command that installs the converter for IFC files. Paste it into a terminal, then open the file again</source>
        <translation>Kopiert den Befehl, der den Umwandler für IFC-Dateien installiert. Fügen Sie ihn in ein Terminal ein und öffnen Sie die Datei dann erneut</translation>
    </message>
</context>
<context>
    <name>footfall::ui::InspectionFeature</name>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Show why the last clicked place is walkable or not</source>
        <translation>Zeigen, warum die zuletzt angeklickte Stelle begehbar ist oder nicht</translation>
    </message>
    <message>
        <source>&amp;Why?</source>
        <translation>&amp;Warum?</translation>
    </message>
    <message>
        <source>Click a place to learn why it is walkable, or what stands in the way</source>
        <translation>Eine Stelle anklicken und erfahren, warum sie begehbar ist oder was im Weg steht</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>List the connected parts of the walkable area by their size</source>
        <translation>Die zusammenhängenden Teile der begehbaren Fläche nach Größe auflisten</translation>
    </message>
    <message>
        <source>Nothing is there; click the level itself.</source>
        <translation>Dort ist nichts; klicken Sie das Level selbst an.</translation>
    </message>
    <message>
        <source>There is no result yet; the answer follows when a run has finished.</source>
        <translation>Es gibt noch kein Ergebnis; die Antwort folgt, wenn ein Lauf fertig ist.</translation>
    </message>
    <message>
        <source>This filter is not in the list any more.</source>
        <translation>Dieser Filter ist nicht mehr in der Liste.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::InspectionWatch</name>
    <message>
        <source>Why: memory ran out; close other programs or use a smaller environment</source>
        <translation>Warum: Der Speicher reicht nicht; schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::Language</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Takes effect when Footfall is started the next time</source>
        <translation>Gilt, sobald Footfall das nächste Mal gestartet wird</translation>
    </message>
    <message>
        <source>Language: as the &amp;system</source>
        <translation>Sprache: wie das &amp;System</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LayerPanel</name>
    <message>
        <source>No result yet</source>
        <translation>Noch kein Ergebnis</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Show all layers again</source>
        <translation>Wieder alle Ebenen zeigen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Walkable triangles</source>
        <translation>Begehbare Dreiecke</translation>
    </message>
    <message>
        <source>Whether the view shows it</source>
        <translation>Ob die Ansicht sie zeigt</translation>
    </message>
    <message>
        <source>Walkable area</source>
        <translation>Begehbare Fläche</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>Not divided into layers; add a layer filter to tell floors apart</source>
        <translation>Nicht in Ebenen geteilt; fügen Sie einen Ebenenfilter hinzu, um Stockwerke zu unterscheiden</translation>
    </message>
    <message>
        <source>%1 of %2 layers shown</source>
        <translation>%1 von %2 Ebenen gezeigt</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 Ebene</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 Ebenen</translation>
    </message>
    <message>
        <source>The eye (or Space) hides and shows a layer. A click on a row (or Enter) shows it alone, another one shows all again; a double click brings it into sight. Walls stay: see the view mode Walkable only, or the heights.</source>
        <translation>Das Auge (oder die Leertaste) blendet eine Ebene aus und ein. Ein Klick auf eine Zeile (oder die Eingabetaste) zeigt sie allein, ein weiterer wieder alle; ein Doppelklick bringt sie ins Bild. Wände bleiben: siehe die Darstellung „Nur Begehbares“ oder die Höhen.</translation>
    </message>
    <message>
        <source>Of the surface</source>
        <translation>Der Oberfläche</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>Fläche (%1)</translation>
    </message>
    <message>
        <source>%1 (as few as possible)</source>
        <translation>%1 (so wenige wie möglich)</translation>
    </message>
    <message>
        <source>%1 (at least 1 is needed)</source>
        <translation>%1 (mindestens 1 ist nötig)</translation>
    </message>
    <message>
        <source>%1 (at least %2 are needed)</source>
        <translation>%1 (mindestens %2 sind nötig)</translation>
    </message>
    <message>
        <source>1 connection</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 Verbindungen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::Legend</name>
    <message>
        <source>Walkable</source>
        <translation>Begehbar</translation>
    </message>
    <message>
        <source>Where an agent can stand and walk</source>
        <translation>Wo ein Agent stehen und gehen kann</translation>
    </message>
    <message>
        <source>Obstacle edge: not to be crossed</source>
        <translation>Hinderniskante: nicht zu überqueren</translation>
    </message>
    <message>
        <source>Walkable on both sides, but an agent cannot cross: a wall stands on it</source>
        <translation>Auf beiden Seiten begehbar, aber nicht zu überqueren: Eine Wand steht darauf</translation>
    </message>
    <message>
        <source>Connection of two layers</source>
        <translation>Verbindung zweier Ebenen</translation>
    </message>
    <message>
        <source>An edge on which two layers meet: agents can cross</source>
        <translation>Eine Kante, an der sich zwei Ebenen treffen: Agenten können hinüber</translation>
    </message>
    <message>
        <source>Not walkable because:</source>
        <translation>Nicht begehbar, weil:</translation>
    </message>
    <message>
        <source>Floors that a filter removed</source>
        <translation>Böden, die ein Filter entfernt hat</translation>
    </message>
    <message>
        <source>Walls, ceilings and the rest</source>
        <translation>Wände, Decken und der Rest</translation>
    </message>
    <message>
        <source>The loaded triangles</source>
        <translation>Die geladenen Dreiecke</translation>
    </message>
    <message>
        <source>Walkable, 1 layer</source>
        <translation>Begehbar, 1 Ebene</translation>
    </message>
    <message>
        <source>Walkable, %1 layers</source>
        <translation>Begehbar, %1 Ebenen</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>Slope of floors</source>
        <translation>Neigung der Böden</translation>
    </message>
    <message>
        <source>%1 (computing)</source>
        <translation>%1 (wird berechnet)</translation>
    </message>
    <message>
        <source>%1, limit %2</source>
        <translation>%1, Grenze %2</translation>
    </message>
    <message>
        <source>Hatched: steeper than the limit of the slope filter</source>
        <translation>Schraffiert: steiler als die Grenze des Neigungsfilters</translation>
    </message>
    <message>
        <source>Hatched: less than the clearance filter needs</source>
        <translation>Schraffiert: weniger, als der Höhenfilter verlangt</translation>
    </message>
    <message>
        <source>Walkable, by source triangle</source>
        <translation>Begehbar, nach Quelldreieck</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Free height above floors, in %1</source>
        <translation>Freie Höhe über Böden, in %1</translation>
    </message>
    <message>
        <source>Step: can be climbed</source>
        <translation>Stufe: kann gestiegen werden</translation>
    </message>
    <message>
        <source>Two borders above each other that an agent can step between</source>
        <translation>Zwei Ränder übereinander, zwischen denen ein Agent steigen kann</translation>
    </message>
    <message>
        <source>Gap: can be stepped over</source>
        <translation>Lücke: darüber kann man treten</translation>
    </message>
    <message>
        <source>Two borders beside each other that an agent can step between</source>
        <translation>Zwei Ränder nebeneinander, zwischen denen ein Agent hinübertreten kann</translation>
    </message>
    <message>
        <source>Drop: one way down</source>
        <translation>Sprung: nur hinab</translation>
    </message>
    <message>
        <source>A ledge from which an agent drops to a lower place, along the arrows, and does not come back</source>
        <translation>Eine Kante, von der ein Agent entlang der Pfeile auf eine tiefere Stelle springt, ohne zurückzukommen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LevelLook</name>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>List the layers, hide and show them</source>
        <translation>Die Ebenen auflisten, aus- und einblenden</translation>
    </message>
    <message>
        <source>Next floor &amp;up</source>
        <translation>Stockwerk &amp;höher</translation>
    </message>
    <message>
        <source>Show only the next layer, or the next storey where there are no layers</source>
        <translation>Nur die nächste Ebene zeigen, oder das nächste Stockwerk, wo es keine Ebenen gibt</translation>
    </message>
    <message>
        <source>Next floor &amp;down</source>
        <translation>Stockwerk &amp;tiefer</translation>
    </message>
    <message>
        <source>Show only the layer before, or the storey below</source>
        <translation>Nur die vorige Ebene zeigen, oder das Stockwerk darunter</translation>
    </message>
    <message>
        <source>Show &amp;all floors</source>
        <translation>&amp;Alle Stockwerke zeigen</translation>
    </message>
    <message>
        <source>Show all layers and heights again</source>
        <translation>Wieder alle Ebenen und Höhen zeigen</translation>
    </message>
    <message>
        <source>&amp;Cut plane</source>
        <translation>S&amp;chnittebene</translation>
    </message>
    <message>
        <source>Cut the view with an upright plane</source>
        <translation>Die Ansicht mit einer aufrechten Ebene schneiden</translation>
    </message>
    <message>
        <source>Look &amp;inside</source>
        <translation>Hineinse&amp;hen</translation>
    </message>
    <message>
        <source>Hide faces seen from behind, and roofs and outer walls while the camera looks down, to show the floors inside</source>
        <translation>Flächen ausblenden, die von hinten zu sehen sind, und beim Blick nach unten auch Dächer und Außenwände, um die Böden innen zu zeigen</translation>
    </message>
    <message>
        <source>Roofs and outer walls are open: %1 closes them.
The handles of Height show a single storey.</source>
        <translation>Dächer und Außenwände sind offen: %1 schließt sie.
Die Griffe der Höhe zeigen ein einzelnes Stockwerk.</translation>
    </message>
    <message>
        <source>Layer %1 of %2</source>
        <translation>Ebene %1 von %2</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LevelOpening</name>
    <message>
        <source>Environments and sessions (%1)</source>
        <translation>Umgebungen und Sitzungen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open an environment or a session</source>
        <translation>Eine Umgebung oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Your filters were kept for this environment.</source>
        <translation>Ihre Filter wurden für diese Umgebung behalten.</translation>
    </message>
    <message>
        <source>Use default filters</source>
        <translation>Vorgegebene Filter verwenden</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LevelUnits</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Places are in the file&apos;s frame (%1), in %2</source>
        <translation>Orte sind im Bezugssystem der Datei (%1), in %2</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 oben</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LevelView</name>
    <message>
        <source>View of the level</source>
        <translation>Ansicht des Levels</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LoadPanel</name>
    <message>
        <source>Run in parallel</source>
        <translation>Parallel ausführen</translation>
    </message>
    <message>
        <source>Put an automatic strategy and a Collapse around the local filters; one step of undo</source>
        <translation>Eine automatische Strategie und ein Collapse um die lokalen Filter setzen; ein Schritt zum Rückgängigmachen</translation>
    </message>
    <message>
        <source>Parallel block</source>
        <translation>Paralleler Block</translation>
    </message>
    <message>
        <source>Which parallel block is shown</source>
        <translation>Welcher parallele Block gezeigt wird</translation>
    </message>
    <message>
        <source>Show the last run</source>
        <translation>Den letzten Lauf zeigen</translation>
    </message>
    <message>
        <source>Leave the preview</source>
        <translation>Die Vorschau verlassen</translation>
    </message>
    <message>
        <source>Open an environment to see how the work on it is spread over threads.</source>
        <translation>Öffnen Sie eine Umgebung, um zu sehen, wie die Arbeit daran auf Threads verteilt ist.</translation>
    </message>
    <message>
        <source>The cells of the parallel block show here as soon as they are made.</source>
        <translation>Die Zellen des parallelen Blocks erscheinen hier, sobald es sie gibt.</translation>
    </message>
    <message>
        <source>This pipeline has no parallel block. Add a strategy before the local filters and a Collapse behind them to divide the environment into cells, and to see here how the work is spread.</source>
        <translation>Diese Pipeline hat keinen parallelen Block. Setzen Sie eine Strategie vor die lokalen Filter und ein Collapse dahinter, um die Umgebung in Zellen zu teilen und hier zu sehen, wie die Arbeit verteilt ist.</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>%1, before a run</source>
        <translation>%1, vor einem Lauf</translation>
    </message>
    <message>
        <source>%1 of %2 finished</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Block %1</translation>
    </message>
    <message>
        <source>Expected: imbalance &lt;b&gt;%1&lt;/b&gt; on %2 threads</source>
        <translation>Erwartet: Ungleichgewicht &lt;b&gt;%1&lt;/b&gt; auf %2 Threads</translation>
    </message>
    <message>
        <source>Imbalance &lt;b&gt;%1&lt;/b&gt;</source>
        <translation>Ungleichgewicht &lt;b&gt;%1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>, speed-up &lt;b&gt;%1&lt;/b&gt; on %2 threads</source>
        <translation>, Beschleunigung &lt;b&gt;%1&lt;/b&gt; auf %2 Threads</translation>
    </message>
    <message>
        <source>Load imbalance: the busiest thread&apos;s time over the mean, 1 at best. Speed-up: the work of all threads on cells over the time that the cells took.</source>
        <translation>Ungleichgewicht: die Zeit des am meisten beschäftigten Threads durch das Mittel, bestenfalls 1. Beschleunigung: die Arbeit aller Threads an Zellen durch die Zeit, die die Zellen brauchten.</translation>
    </message>
    <message>
        <source>The whole run: %1</source>
        <translation>Der ganze Lauf: %1</translation>
    </message>
    <message>
        <source>Filters below the cells: </source>
        <translation>Filter unter den Zellen: </translation>
    </message>
    <message>
        <source>Before a run: the cells by estimated cost, each on the first free thread.</source>
        <translation>Vor einem Lauf: die Zellen nach geschätztem Aufwand, jede auf dem ersten freien Thread.</translation>
    </message>
    <message>
        <source>The lanes of the threads fill when cells run.</source>
        <translation>Die Spuren der Threads füllen sich, wenn Zellen laufen.</translation>
    </message>
    <message>
        <source>Threads of a run</source>
        <translation>Threads eines Laufs</translation>
    </message>
    <message>
        <source>The largest number of threads of a run; the result does not depend on it</source>
        <translation>Die größte Zahl der Threads eines Laufs; das Ergebnis hängt nicht davon ab</translation>
    </message>
    <message>
        <source>Expected: imbalance &lt;b&gt;%1&lt;/b&gt; on 1 thread</source>
        <translation>Erwartet: Ungleichgewicht &lt;b&gt;%1&lt;/b&gt; auf 1 Thread</translation>
    </message>
    <message>
        <source>, speed-up &lt;b&gt;%1&lt;/b&gt; on 1 thread</source>
        <translation>, Beschleunigung &lt;b&gt;%1&lt;/b&gt; auf 1 Thread</translation>
    </message>
    <message>
        <source>Run on</source>
        <translation>Rechnen auf</translation>
    </message>
    <message>
        <source>Where the cells of a run are computed; the result does not depend on it</source>
        <translation>Wo die Zellen eines Laufs berechnet werden; das Ergebnis hängt nicht davon ab</translation>
    </message>
    <message numerus="yes">
        <source>, speed-up &lt;b&gt;%1&lt;/b&gt; on %n rank(s)</source>
        <translation>
            <numerusform>, Beschleunigung &lt;b&gt;%1&lt;/b&gt; auf %n Rang</numerusform>
            <numerusform>, Beschleunigung &lt;b&gt;%1&lt;/b&gt; auf %n Rängen</numerusform>
        </translation>
    </message>
    <message>
        <source>Pages of the load</source>
        <translation>Seiten der Auslastung</translation>
    </message>
    <message>
        <source>How the time of all threads was used</source>
        <translation>Wofür die Zeit aller Threads verwendet wurde</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phasen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>from the cache: figures of the run that computed it</source>
        <translation>aus dem Cache: Zahlen des Laufs, der ihn berechnet hat</translation>
    </message>
    <message>
        <source>measured: the median run</source>
        <translation>gemessen: der mittlere Lauf</translation>
    </message>
    <message>
        <source>No cell has run yet.</source>
        <translation>Noch ist keine Zelle gelaufen.</translation>
    </message>
    <message>
        <source>The time of all threads from the beginning of the run to its end: %1</source>
        <translation>Die Zeit aller Threads vom Anfang des Laufs bis zu seinem Ende: %1</translation>
    </message>
    <message>
        <source>hatched: waiting for work</source>
        <translation>schraffiert: Warten auf Arbeit</translation>
    </message>
    <message>
        <source>dotted: waiting for a serial step</source>
        <translation>gepunktet: Warten auf einen seriellen Schritt</translation>
    </message>
    <message numerus="yes">
        <source>%n from the cache</source>
        <translation>
            <numerusform>%n aus dem Cache</numerusform>
            <numerusform>%n aus dem Cache</numerusform>
        </translation>
    </message>
    <message>
        <source>crossed out: from the cache</source>
        <translation>gekreuzt: aus dem Cache</translation>
    </message>
</context>
<context>
    <name>footfall::ui::LogPanel</name>
    <message>
        <source>Which messages are shown</source>
        <translation>Welche Meldungen gezeigt werden</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Hints and errors</source>
        <translation>Hinweise und Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search in the messages</source>
        <translation>In den Meldungen suchen</translation>
    </message>
    <message>
        <source>Show messages with this text</source>
        <translation>Meldungen mit diesem Text zeigen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all that are shown</source>
        <translation>Die ausgewählten Meldungen kopieren, oder alle gezeigten</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Save the selected messages, or all that are shown, as a text file</source>
        <translation>Die ausgewählten Meldungen als Textdatei speichern, oder alle gezeigten</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Forget all messages</source>
        <translation>Alle Meldungen vergessen</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::MeasureFeature</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Distances, heights and slopes between places</source>
        <translation>Abstände, Höhen und Neigungen zwischen Stellen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Distance, height and slope between places that you click</source>
        <translation>Abstand, Höhe und Neigung zwischen Stellen, die Sie anklicken</translation>
    </message>
    <message>
        <source>Click two places whose distance you know, and type it</source>
        <translation>Zwei Stellen anklicken, deren Abstand bekannt ist, und ihn eingeben</translation>
    </message>
    <message>
        <source>Scale b&amp;y reference...</source>
        <translation>Maßstab nach Ver&amp;gleich...</translation>
    </message>
</context>
<context>
    <name>footfall::ui::MeasurePage</name>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>least</source>
        <translation>kleinster</translation>
    </message>
    <message>
        <source>most</source>
        <translation>größter</translation>
    </message>
    <message>
        <source>whole run</source>
        <translation>ganzer Lauf</translation>
    </message>
    <message>
        <source>imbalance</source>
        <translation>Ungleichgewicht</translation>
    </message>
    <message>
        <source>processors in use</source>
        <translation>genutzte Prozessoren</translation>
    </message>
    <message>
        <source>taken by other programs</source>
        <translation>von anderen Programmen belegt</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> Läufe</translation>
    </message>
    <message>
        <source>How many runs</source>
        <translation>Wie viele Läufe</translation>
    </message>
    <message>
        <source>The number of runs, one after the other</source>
        <translation>Die Zahl der Läufe, einer nach dem anderen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Run %1 of %2 is under way.</source>
        <translation>Lauf %1 von %2 ist im Gang.</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Run the whole pipeline several times, without caches</source>
        <translation>Die ganze Pipeline mehrmals ausführen, ohne Zwischenspeicher</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), nothing from caches; the timeline shows the median one.</source>
        <translation>
            <numerusform>%n Lauf, nichts aus Caches; die Zeitleiste zeigt ihn.</numerusform>
            <numerusform>%n Läufe, nichts aus Caches; die Zeitleiste zeigt den mittleren.</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs the whole pipeline anew, without caches and previews. An edit stops it.</source>
        <translation>Rechnet die ganze Pipeline neu, ohne Caches und Vorschauen. Eine Änderung hält es an.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::MeasurePanel</name>
    <message>
        <source>Measured pieces</source>
        <translation>Gemessene Stücke</translation>
    </message>
    <message>
        <source>Slope °</source>
        <translation>Neigung °</translation>
    </message>
    <message>
        <source>Slope %</source>
        <translation>Neigung %</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy places and measures as a table</source>
        <translation>Stellen und Maße als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Remove last</source>
        <translation>Letzte entfernen</translation>
    </message>
    <message>
        <source>Remove the last place</source>
        <translation>Die letzte Stelle entfernen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Remove all places</source>
        <translation>Alle Stellen entfernen</translation>
    </message>
    <message>
        <source>Click two or more places in the view.</source>
        <translation>Klicken Sie zwei oder mehr Stellen in der Ansicht an.</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>From %1
to %2</source>
        <translation>Von %1
bis %2</translation>
    </message>
    <message>
        <source>Together %1, in the plan %2</source>
        <translation>Zusammen %1, im Grundriss %2</translation>
    </message>
    <message>
        <source>Each piece between two places; height and slope from the first place to the second</source>
        <translation>Jedes Stück zwischen zwei Orten; Höhe und Neigung vom ersten zum zweiten</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>In plan</source>
        <translation>Im Grundriss</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Set scale...</source>
        <translation>Maßstab setzen...</translation>
    </message>
    <message>
        <source>Enter the length of the last piece in metres, to set the scale of the level</source>
        <translation>Die Länge des letzten Stücks in Metern eingeben, um den Maßstab des Levels zu setzen</translation>
    </message>
    <message>
        <source>Scale by reference</source>
        <translation>Maßstab nach Vergleich</translation>
    </message>
    <message>
        <source>The last piece is %1 of the file&apos;s units long. How many metres is that?</source>
        <translation>Das letzte Stück ist %1 Einheiten der Datei lang. Wie viele Meter sind das?</translation>
    </message>
</context>
<context>
    <name>footfall::ui::MeasureTool</name>
    <message>
        <source>%1 (%2 in the plan), height %3, %4</source>
        <translation>%1 (%2 im Grundriss), Höhe %3, %4</translation>
    </message>
    <message>
        <source>Measure: click two or more places. Enter ends the line, Backspace takes a place back, Ctrl+C copies, Esc ends.</source>
        <translation>Messen: Klicken Sie zwei oder mehr Stellen an. Eingabe beendet die Linie, Rücktaste nimmt eine Stelle zurück, Strg+C kopiert, Esc beendet.</translation>
    </message>
    <message>
        <source>x	y	z	distance	in the plan	height	degrees	percent</source>
        <translation>x	y	z	Abstand	im Grundriss	Höhe	Grad	Prozent</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>%1
plan %2, height %3
%4</source>
        <translation>%1
Grundriss %2, Höhe %3
%4</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Ecke</translation>
    </message>
</context>
<context>
    <name>footfall::ui::MessageBar</name>
    <message>
        <source>Close this message; the log keeps it</source>
        <translation>Diese Meldung schließen; das Protokoll behält sie</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fehler: %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::MessageLog</name>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
</context>
<context>
    <name>footfall::ui::NumberField</name>
    <message>
        <source>not a number; write decimals with a point</source>
        <translation>keine Zahl; schreiben Sie Dezimalen mit einem Punkt</translation>
    </message>
    <message>
        <source>not a number; give %1</source>
        <translation>keine Zahl; geben Sie %1</translation>
    </message>
    <message>
        <source>%1; it stays %2</source>
        <translation>%1; es bleibt %2</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>not a number; leave out what stands between thousands</source>
        <translation>keine Zahl; lassen Sie weg, was zwischen den Tausendern steht</translation>
    </message>
    <message>
        <source>%1 = %2 %3 of the file</source>
        <translation>%1 = %2 %3 der Datei</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ObstacleEditor</name>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 verdoppeln</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ObstacleFeatures</name>
    <message>
        <source>&amp;Select and move obstacles</source>
        <translation>Hindernisse au&amp;swählen und bewegen</translation>
    </message>
    <message>
        <source>Select obstacles; move, turn and resize them with handles</source>
        <translation>Hindernisse auswählen; mit Griffen bewegen, drehen und ihre Größe ändern</translation>
    </message>
    <message>
        <source>Place a &amp;box</source>
        <translation>&amp;Quader setzen</translation>
    </message>
    <message>
        <source>Place a &amp;cylinder</source>
        <translation>&amp;Zylinder setzen</translation>
    </message>
    <message>
        <source>Place a &amp;ramp</source>
        <translation>&amp;Rampe setzen</translation>
    </message>
    <message>
        <source>Click where a box is to stand, or draw its base and then its height</source>
        <translation>Klicken Sie, wo ein Quader stehen soll, oder ziehen Sie seine Grundfläche und dann seine Höhe auf</translation>
    </message>
    <message>
        <source>Click where a cylinder is to stand, or draw its base and then its height</source>
        <translation>Klicken Sie, wo ein Zylinder stehen soll, oder ziehen Sie seine Grundfläche und dann seine Höhe auf</translation>
    </message>
    <message>
        <source>Click where a ramp is to stand, or draw its base, the way it rises, and then its height</source>
        <translation>Klicken Sie, wo eine Rampe stehen soll, oder ziehen Sie ihre Grundfläche in Steigrichtung und dann ihre Höhe auf</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Hindernisse</translation>
    </message>
    <message>
        <source>List of placed obstacles, with their places and sizes in numbers</source>
        <translation>Liste der gesetzten Hindernisse, mit Orten und Größen in Zahlen</translation>
    </message>
    <message>
        <source>&amp;Duplicate obstacle</source>
        <translation>Hindernis ver&amp;doppeln</translation>
    </message>
    <message>
        <source>A copy beside the selected obstacle</source>
        <translation>Eine Kopie neben dem ausgewählten Hindernis</translation>
    </message>
    <message>
        <source>D&amp;elete obstacle</source>
        <translation>Hindernis lösch&amp;en</translation>
    </message>
    <message>
        <source>Take the selected obstacle out of the level</source>
        <translation>Das ausgewählte Hindernis aus dem Level nehmen</translation>
    </message>
    <message>
        <source>%1: %2; size %3; %4°</source>
        <translation>%1: %2; Größe %3; %4°</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ObstaclePanel</name>
    <message>
        <source>Obstacles</source>
        <translation>Hindernisse</translation>
    </message>
    <message>
        <source>What was placed into the level; a double click brings it into sight</source>
        <translation>Was ins Level gesetzt wurde; ein Doppelklick bringt es ins Bild</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Choose a shape, then click in the view where it is to stand</source>
        <translation>Form wählen, dann in der Ansicht klicken, wo sie stehen soll</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>A copy beside the selected obstacle (Ctrl+D)</source>
        <translation>Eine Kopie neben dem ausgewählten Hindernis (Strg+D)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take the selected obstacle out of the level (Del)</source>
        <translation>Das ausgewählte Hindernis aus dem Level nehmen (Entf)</translation>
    </message>
    <message>
        <source>Name of the obstacle</source>
        <translation>Name des Hindernisses</translation>
    </message>
    <message>
        <source>Its name in this list, in undo and in exports</source>
        <translation>Sein Name in dieser Liste, beim Rückgängigmachen und in Exporten</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Base x</source>
        <translation>Grund x</translation>
    </message>
    <message>
        <source>Base y</source>
        <translation>Grund y</translation>
    </message>
    <message>
        <source>Base z</source>
        <translation>Grund z</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>About the vertical, in degrees, counter-clockwise from above</source>
        <translation>Um die Senkrechte, in Grad, von oben gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Base x, y, z</source>
        <translation>Grund x, y, z</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Stick to the ground</source>
        <translation>Am Boden haften</translation>
    </message>
    <message>
        <source>Obstacles that are moved sideways follow the ground: up to a metre up, and down to any depth</source>
        <translation>Seitwärts bewegte Hindernisse folgen dem Boden: bis einen Meter hinauf und beliebig tief hinab</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>in %1 umbenennen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Resize %1</source>
        <translation>Größe von %1 ändern</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Length, width, height</source>
        <translation>Länge, Breite, Höhe</translation>
    </message>
    <message>
        <source>Height of its bottom, along the file&apos;s %1, in %2</source>
        <translation>Höhe der Unterseite, entlang %1 der Datei, in %2</translation>
    </message>
    <message>
        <source>Middle of its bottom, along the file&apos;s %1, in %2</source>
        <translation>Mitte der Unterseite, entlang %1 der Datei, in %2</translation>
    </message>
    <message>
        <source>Extent along its own length, in %1; a ramp rises along it</source>
        <translation>Ausdehnung in der eigenen Länge, in %1; eine Rampe steigt an ihr entlang</translation>
    </message>
    <message>
        <source>Extent across its length, in %1</source>
        <translation>Ausdehnung quer zur Länge, in %1</translation>
    </message>
    <message>
        <source>Extent upward, in %1</source>
        <translation>Ausdehnung nach oben, in %1</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
</context>
<context>
    <name>footfall::ui::OverlayFrame</name>
    <message>
        <source>Unfold; drag to move, double click to put it back</source>
        <translation>Ausklappen; Ziehen verschiebt, ein Doppelklick setzt sie zurück</translation>
    </message>
    <message>
        <source>Fold; drag to move, double click to put it back</source>
        <translation>Einklappen; Ziehen verschiebt, ein Doppelklick setzt sie zurück</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PackedFeature</name>
    <message>
        <source>Run on the visi&amp;ble part</source>
        <translation>Auf dem &amp;sichtbaren Teil ausführen</translation>
    </message>
    <message>
        <source>Run the filters on the part in the middle of the view, in an environment that is too large to run whole</source>
        <translation>Die Filter auf dem Teil in der Mitte der Ansicht ausführen, bei einer Umgebung, die als Ganzes zu groß ist</translation>
    </message>
    <message>
        <source>The parts of a large environment that the view shows in full</source>
        <translation>Die Teile einer großen Umgebung, die die Ansicht vollständig zeigt</translation>
    </message>
    <message>
        <source>The visible place has more than %1 triangles; the part is smaller.</source>
        <translation>Die sichtbare Stelle hat mehr als %1 Dreiecke; der Teil ist kleiner.</translation>
    </message>
    <message>
        <source>%1 has %2 million triangles. The view shows them coarse, and in full where you look; filters run on the part in the frame. All of it: footfall run --memory.</source>
        <translation>%1 hat %2 Millionen Dreiecke. Die Ansicht zeigt sie grob, und wohin Sie sehen vollständig; die Filter laufen auf dem Teil im Rahmen. Alles: footfall run --memory.</translation>
    </message>
    <message>
        <source>Run on the visible part</source>
        <translation>Auf dem sichtbaren Teil ausführen</translation>
    </message>
    <message>
        <source>Coarse; in full: %1 of %2 blocks, %3 of %4 million triangles</source>
        <translation>Grob; vollständig: %1 von %2 Blöcken, %3 von %4 Millionen Dreiecken</translation>
    </message>
    <message>
        <source>Only the part in the frame is known.</source>
        <translation>Bekannt ist nur der Teil im Rahmen.</translation>
    </message>
    <message>
        <source>A file is being read; until that is done, the part stays where it is.</source>
        <translation>Eine Datei wird gelesen; bis das fertig ist, bleibt der Teil, wo er ist.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ParameterHandles</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 (here %3)</source>
        <translation>%1: %2 (hier %3)</translation>
    </message>
    <message>
        <source>Drag the handle to change the value. Shift: finer, Esc: back.</source>
        <translation>Den Griff ziehen, um den Wert zu ändern. Umschalt: feiner, Esc: zurück.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ParameterNotes</name>
    <message>
        <source>Set the scale to %1</source>
        <translation>Maßstab auf %1 setzen</translation>
    </message>
    <message>
        <source>Set %1 to %2</source>
        <translation>%1 auf %2 setzen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PartLevel</name>
    <message>
        <source>the roles of parts cannot be applied (%1); close other programs or use a smaller environment</source>
        <translation>Die Rollen der Teile können nicht angewandt werden (%1); schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PartModel</name>
    <message>
        <source>(no material)</source>
        <translation>(kein Material)</translation>
    </message>
    <message>
        <source>(unnamed)</source>
        <translation>(ohne Namen)</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>mesh and its only material</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>obstacle only</source>
        <translation>nur Hindernis</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>as usual</source>
        <translation>wie sonst</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>Mesh: %1
%2 materials</source>
        <translation>Netz: %1
%2 Materialien</translation>
    </message>
    <message>
        <source>Mesh: %1
Material: %2</source>
        <translation>Netz: %1
Material: %2</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>(kein Name)</translation>
    </message>
    <message>
        <source>%1, %2, triangles: %3</source>
        <translation>%1, %2, Dreiecke: %3</translation>
    </message>
    <message>
        <source>Mesh, material</source>
        <translation>Netz, Material</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PartPanel</name>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Filter meshes and materials by name</source>
        <translation>Netze und Materialien nach Namen filtern</translation>
    </message>
    <message>
        <source>Shows only meshes and materials whose names contain this</source>
        <translation>Zeigt nur Netze und Materialien, deren Name dies enthält</translation>
    </message>
    <message>
        <source>Meshes and materials</source>
        <translation>Netze und Materialien</translation>
    </message>
    <message>
        <source>Open an environment to see its meshes and materials.</source>
        <translation>Öffnen Sie eine Umgebung, um ihre Netze und Materialien zu sehen.</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Wie sonst</translation>
    </message>
    <message>
        <source>Selected parts are walkable where the filters let them be</source>
        <translation>Ausgewählte Teile sind begehbar, wo die Filter es zulassen</translation>
    </message>
    <message>
        <source>Obstacle only</source>
        <translation>Nur Hindernis</translation>
    </message>
    <message>
        <source>Nobody walks on selected parts, but they still stand in the way</source>
        <translation>Auf ausgewählten Teilen geht niemand, aber sie stehen weiter im Weg</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>Selected parts are left out, as if the file did not have them</source>
        <translation>Ausgewählte Teile werden weggelassen, als hätte die Datei sie nicht</translation>
    </message>
    <message>
        <source>Show in the View</source>
        <translation>In der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Brings the selected parts into sight (double click, Return)</source>
        <translation>Bringt die ausgewählten Teile ins Bild (Doppelklick, Eingabetaste)</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>Ignore %1</source>
        <translation>%1 weglassen</translation>
    </message>
    <message>
        <source>Make %1 an obstacle only</source>
        <translation>%1 nur zum Hindernis machen</translation>
    </message>
    <message>
        <source>Make %1 walkable as usual</source>
        <translation>%1 wie sonst begehbar machen</translation>
    </message>
    <message>
        <source>Include %1</source>
        <translation>%1 wieder aufnehmen</translation>
    </message>
    <message>
        <source>Selected: %1, %2 triangles</source>
        <translation>Ausgewählt: %1, %2 Dreiecke</translation>
    </message>
    <message>
        <source>Of %1 triangles, %2 ignored and %3 obstacles only</source>
        <translation>Von %1 Dreiecken %2 weggelassen und %3 nur Hindernis</translation>
    </message>
    <message>
        <source>%1 triangles in one part</source>
        <translation>%1 Dreiecke in einem Teil</translation>
    </message>
    <message>
        <source>%1 triangles in %2 parts</source>
        <translation>%1 Dreiecke in %2 Teilen</translation>
    </message>
    <message>
        <source>Selected: %1, 1 triangle</source>
        <translation>Ausgewählt: %1, 1 Dreieck</translation>
    </message>
    <message>
        <source>1 triangle in one part</source>
        <translation>1 Dreieck in einem Teil</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PassageView</name>
    <message>
        <source>Show the &amp;passage</source>
        <translation>&amp;Durchgang zeigen</translation>
    </message>
    <message>
        <source>Show the &amp;place</source>
        <translation>&amp;Ort zeigen</translation>
    </message>
    <message>
        <source>Bring the narrowest passage of the way into sight</source>
        <translation>Den schmalsten Durchgang des Wegs ins Bild holen</translation>
    </message>
    <message>
        <source>Bring a place with enough room into sight</source>
        <translation>Einen Ort mit genug Platz ins Bild holen</translation>
    </message>
    <message>
        <source>%1, %2 too narrow</source>
        <translation>%1, um %2 zu schmal</translation>
    </message>
    <message>
        <source>Enough room</source>
        <translation>Genug Platz</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PathFeature</name>
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Enter two places and see the shortest path between them</source>
        <translation>Zwei Stellen eingeben und den kürzesten Weg dazwischen sehen</translation>
    </message>
    <message>
        <source>&amp;Try it</source>
        <translation>&amp;Ausprobieren</translation>
    </message>
    <message>
        <source>Click two places and see the shortest path between them</source>
        <translation>Zwei Stellen anklicken und den kürzesten Weg dazwischen sehen</translation>
    </message>
    <message>
        <source>Open an environment first.</source>
        <translation>Öffnen Sie zuerst eine Umgebung.</translation>
    </message>
    <message>
        <source>There is no result to walk on yet.</source>
        <translation>Es gibt noch kein Ergebnis, auf dem man gehen könnte.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PathModel</name>
    <message>
        <source>the path: memory ran out; close other programs or use a smaller environment</source>
        <translation>Der Weg: Der Speicher reicht nicht; schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PathPanel</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Walking speed in metres a second</source>
        <translation>Gehgeschwindigkeit in Metern je Sekunde</translation>
    </message>
    <message>
        <source>Walking speed in metres a second, for the time that the path takes</source>
        <translation>Gehgeschwindigkeit in Metern je Sekunde, für die Dauer des Wegs</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Swap start and target</source>
        <translation>Start und Ziel vertauschen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy places and figures as text</source>
        <translation>Stellen und Zahlen als Text kopieren</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Remove both places</source>
        <translation>Beide Stellen entfernen</translation>
    </message>
    <message>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>Click two places in the view, or enter them here.</source>
        <translation>Klicken Sie zwei Stellen in der Ansicht an, oder geben Sie sie hier ein.</translation>
    </message>
    <message>
        <source>Measuring the passages …</source>
        <translation>Die Durchgänge werden vermessen …</translation>
    </message>
    <message>
        <source>The filter Radius is left out: the body has a radius of its own.</source>
        <translation>Der Filter Radius bleibt außer Betracht: Der Körper hat seinen eigenen Radius.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PathText</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>Nothing is walkable here.</source>
        <translation>Hier ist nichts begehbar.</translation>
    </message>
    <message>
        <source>The start is not walkable. The nearest walkable place is %1 away, at %2.</source>
        <translation>Der Start ist nicht begehbar. Die nächste begehbare Stelle liegt %1 entfernt, bei %2.</translation>
    </message>
    <message>
        <source>The target is not walkable. The nearest place that can be reached is %1 away, at %2.</source>
        <translation>Das Ziel ist nicht begehbar. Die nächste erreichbare Stelle ist %1 entfernt, bei %2.</translation>
    </message>
    <message>
        <source>There is no way: start and target are on separate parts. The nearest place that can be reached is %1 away, at %2.</source>
        <translation>Es gibt keinen Weg: Start und Ziel liegen auf getrennten Teilen. Die nächste erreichbare Stelle ist %1 entfernt, bei %2.</translation>
    </message>
    <message>
        <source>In the plan %1, 1 bend</source>
        <translation>Im Grundriss %1, 1 Knick</translation>
    </message>
    <message>
        <source>In the plan %1, %2 bends</source>
        <translation>Im Grundriss %1, %2 Knicke</translation>
    </message>
    <message>
        <source>%1 at %2 m/s</source>
        <translation>%1 bei %2 m/s</translation>
    </message>
    <message>
        <source>On layer %1</source>
        <translation>Auf Ebene %1</translation>
    </message>
    <message>
        <source>Layers %1 (%2 connections)</source>
        <translation>Ebenen %1 (%2 Verbindungen)</translation>
    </message>
    <message>
        <source>Slope up to %1, climbs or falls up to %2</source>
        <translation>Neigung bis %1, steigt oder fällt bis %2</translation>
    </message>
    <message>
        <source>Length %1</source>
        <translation>Länge %1</translation>
    </message>
    <message>
        <source>Layers %1 (1 connection)</source>
        <translation>Ebenen %1 (1 Verbindung)</translation>
    </message>
    <message>
        <source>%1 up and %2 down in all</source>
        <translation>insgesamt %1 hinauf und %2 hinab</translation>
    </message>
    <message>
        <source>1 step, %1</source>
        <translation>1 Stufe, %1</translation>
    </message>
    <message>
        <source>%1 steps, %2</source>
        <translation>%1 Stufen, %2</translation>
    </message>
    <message>
        <source>Drops lead from the target to the start, but no way leads back up. The nearest place that can be reached is %1 away, at %2.</source>
        <translation>Sprünge führen vom Ziel zum Start, aber kein Weg führt wieder hinauf. Die nächste erreichbare Stelle ist %1 entfernt, bei %2.</translation>
    </message>
    <message>
        <source>1 gap stepped over</source>
        <translation>über 1 Lücke getreten</translation>
    </message>
    <message>
        <source>%1 gaps stepped over</source>
        <translation>über %1 Lücken getreten</translation>
    </message>
    <message>
        <source>1 drop of %1, one way</source>
        <translation>1 Sprung von %1, nur hinab</translation>
    </message>
    <message>
        <source>%1 drops, one way, the deepest %2</source>
        <translation>%1 Sprünge, nur hinab, der tiefste %2</translation>
    </message>
    <message>
        <source>A place with enough room is at %1.</source>
        <translation>Ein Ort mit genug Platz ist bei %1.</translation>
    </message>
    <message>
        <source>No place around it has enough room.</source>
        <translation>Kein Ort in der Nähe hat genug Platz.</translation>
    </message>
    <message>
        <source>Only drops lead to the target, and a body with a radius takes none.</source>
        <translation>Zum Ziel führen nur Sprünge, und ein Körper mit Radius nimmt keine.</translation>
    </message>
    <message>
        <source>The start is %1 from the border, %2 less than the radius.</source>
        <translation>Der Start ist %1 vom Rand entfernt, %2 weniger als der Radius.</translation>
    </message>
    <message>
        <source>The target is %1 from the border, %2 less than the radius.</source>
        <translation>Das Ziel ist %1 vom Rand entfernt, %2 weniger als der Radius.</translation>
    </message>
    <message>
        <source>No passage leads from the start to the target.</source>
        <translation>Kein Durchgang führt vom Start zum Ziel.</translation>
    </message>
    <message>
        <source>Every way is too narrow. The widest one has a passage of %1 at %2; the body is %3 wide, which is %4 too much.</source>
        <translation>Jeder Weg ist zu schmal. Der breiteste hat einen Durchgang von %1 bei %2; der Körper ist %3 breit, das ist %4 zu viel.</translation>
    </message>
    <message>
        <source>Narrowest passage %1</source>
        <translation>Schmalster Durchgang %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PathTool</name>
    <message>
        <source>Try it: click where the path starts. Esc ends.</source>
        <translation>Ausprobieren: Klicken Sie, wo der Weg beginnt. Esc beendet.</translation>
    </message>
    <message>
        <source>Try it: click where the path leads. Backspace takes the start back, Esc ends.</source>
        <translation>Ausprobieren: Klicken Sie, wohin der Weg führt. Rücktaste nimmt den Start zurück, Esc beendet.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Target: %1</source>
        <translation>Ziel: %1</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Nearest walkable place</source>
        <translation>Nächste begehbare Stelle</translation>
    </message>
    <message>
        <source>The way ends here</source>
        <translation>Hier endet der Weg</translation>
    </message>
    <message>
        <source>Try it: drag an end, click to begin another path, Space walks it. Esc ends.</source>
        <translation>Ausprobieren: Ziehen Sie ein Ende, klicken Sie für einen anderen Weg, die Leertaste geht ihn. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PhasePlot</name>
    <message>
        <source>How the time of the run was used</source>
        <translation>Wofür die Zeit des Laufs verwendet wurde</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PipelineFiles</name>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open a pipeline</source>
        <translation>Eine Pipeline öffnen</translation>
    </message>
    <message>
        <source>Pipelines (*.pipeline *.txt);;All files (*)</source>
        <translation>Pipelines (*.pipeline *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the pipeline</source>
        <translation>Pipeline speichern</translation>
    </message>
    <message>
        <source>Pipelines (*.pipeline)</source>
        <translation>Pipelines (*.pipeline)</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PlaceFields</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2, the file&apos;s vertical axis, in %3</source>
        <translation>%1: %2, die senkrechte Achse der Datei, in %3</translation>
    </message>
    <message>
        <source>%1: %2 of the file, in %3</source>
        <translation>%1: %2 der Datei, in %3</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PlaceObstacleTool</name>
    <message>
        <source>Draw the base; let go to go on with the height. Shift snaps, Esc takes back</source>
        <translation>Grundfläche aufziehen; Loslassen geht zur Höhe weiter. Umschalt rastet ein, Esc nimmt zurück</translation>
    </message>
    <message>
        <source>Move up or down for the height, then click. Shift snaps, Esc takes back</source>
        <translation>Für die Höhe auf oder ab bewegen, dann klicken. Umschalt rastet ein, Esc nimmt zurück</translation>
    </message>
    <message>
        <source>%1: click a surface, or drag over it to draw the base. Ctrl places another one after it, Shift snaps</source>
        <translation>%1: Fläche anklicken oder darüber ziehen, um den Grund aufzuziehen. Strg setzt danach ein weiteres, Umschalt rastet ein</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PlanChoices</name>
    <message>
        <source>&amp;Pages</source>
        <translation>&amp;Seiten</translation>
    </message>
    <message>
        <source>What each page of the plan shows</source>
        <translation>Was jede Seite des Plans zeigt</translation>
    </message>
    <message>
        <source>One for each storey</source>
        <translation>Eine für jedes Geschoss</translation>
    </message>
    <message>
        <source>One for each layer</source>
        <translation>Eine für jede Ebene</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>How large the plan is drawn</source>
        <translation>Wie groß der Plan gezeichnet wird</translation>
    </message>
    <message>
        <source>As large as fits</source>
        <translation>So groß wie möglich</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apier</translation>
    </message>
    <message>
        <source>The size of a page</source>
        <translation>Die Größe einer Seite</translation>
    </message>
    <message>
        <source>As needed</source>
        <translation>Nach Bedarf</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>For the screen or for printing</source>
        <translation>Für den Bildschirm oder zum Drucken</translation>
    </message>
    <message>
        <source>In colour</source>
        <translation>In Farbe</translation>
    </message>
    <message>
        <source>Black and white</source>
        <translation>Schwarzweiß</translation>
    </message>
    <message>
        <source>Corridor &amp;map</source>
        <translation>&amp;Korridorkarte</translation>
    </message>
    <message>
        <source>Draw lines in the middle of all passages</source>
        <translation>Linien in der Mitte aller Durchgänge zeichnen</translation>
    </message>
    <message>
        <source>&amp;Bottlenecks narrower than</source>
        <translation>&amp;Engstellen schmaler als</translation>
    </message>
    <message>
        <source>Draw passages narrower than this as dimension lines with their widths</source>
        <translation>Durchgänge, die schmaler sind, als Maßlinien mit ihrer Breite zeichnen</translation>
    </message>
    <message>
        <source>Width of bottlenecks</source>
        <translation>Breite von Engstellen</translation>
    </message>
    <message>
        <source>Wider passages get no dimension line</source>
        <translation>Breitere Durchgänge bekommen keine Maßlinie</translation>
    </message>
    <message>
        <source>Width of bottlenecks: %1</source>
        <translation>Breite von Engstellen: %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>&amp;Lengths in</source>
        <translation>&amp;Längen in</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>The file&apos;s units</source>
        <translation>Einheiten der Datei</translation>
    </message>
    <message>
        <source>&amp;Threads of runs</source>
        <translation>&amp;Threads der Läufe</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Darstellung</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>L&amp;anguage (from the next start on)</source>
        <translation>&amp;Sprache (ab dem nächsten Start)</translation>
    </message>
    <message>
        <source>&amp;Size of the interface (from the next start on)</source>
        <translation>&amp;Größe der Oberfläche (ab dem nächsten Start)</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Press the new keys of the selected command</source>
        <translation>Die neuen Tasten des ausgewählten Befehls drücken</translation>
    </message>
    <message>
        <source>&amp;Usual keys</source>
        <translation>&amp;Übliche Tasten</translation>
    </message>
    <message>
        <source>&amp;No keys</source>
        <translation>&amp;Keine Tasten</translation>
    </message>
    <message>
        <source>&amp;Reset all</source>
        <translation>Alle &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>%1 is already used by %2; remove it there first.</source>
        <translation>%1 wird schon von „%2“ verwendet; entfernen Sie die Taste zuerst dort.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PresetStore</name>
    <message>
        <source>a preset named &apos;%1&apos; already exists; choose another name</source>
        <translation>Eine Vorlage „%1“ gibt es schon; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>%1: cannot be renamed; check the folder</source>
        <translation>%1: kann nicht umbenannt werden; prüfen Sie den Ordner</translation>
    </message>
    <message>
        <source>%1: cannot be deleted; check the folder</source>
        <translation>%1: kann nicht gelöscht werden; prüfen Sie den Ordner</translation>
    </message>
    <message>
        <source>the preset has no name; give one</source>
        <translation>Die Vorlage hat keinen Namen; geben Sie einen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; begins with a point, or begins or ends with a blank; choose another name</source>
        <translation>„%1“ beginnt mit einem Punkt oder beginnt oder endet mit einem Leerzeichen; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the name is too long; give at most %1 letters</source>
        <translation>Der Name ist zu lang; geben Sie höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>a name of a preset is a name of a file and cannot have &apos;%1&apos;; leave it out</source>
        <translation>Der Name einer Vorlage ist ein Dateiname und kann „%1“ nicht enthalten; lassen Sie es weg</translation>
    </message>
</context>
<context>
    <name>footfall::ui::PresetsMenu</name>
    <message>
        <source>Built in</source>
        <translation>Mitgeliefert</translation>
    </message>
    <message>
        <source>Use preset %1</source>
        <translation>Vorlage %1 verwenden</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>&amp;Save as preset...</source>
        <translation>Als Vorlage &amp;speichern...</translation>
    </message>
    <message>
        <source>&amp;Rename preset</source>
        <translation>Vorlage &amp;umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete preset</source>
        <translation>Vorlage &amp;löschen</translation>
    </message>
    <message>
        <source>Rename the preset</source>
        <translation>Vorlage umbenennen</translation>
    </message>
    <message>
        <source>Save the filters as a preset</source>
        <translation>Die Filter als Vorlage speichern</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; was replaced.</source>
        <translation>Die Vorlage „%1“ wurde ersetzt.</translation>
    </message>
    <message>
        <source>Saved as preset &apos;%1&apos;.</source>
        <translation>Als Vorlage „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; was deleted.</source>
        <translation>Die Vorlage „%1“ wurde gelöscht.</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ProgressDisplay</name>
    <message>
        <source>nearly done</source>
        <translation>fast fertig</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>noch etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h left</source>
        <translation>noch etwa %1 h</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>longer than estimated</source>
        <translation>länger als geschätzt</translation>
    </message>
    <message>
        <source>time left unknown</source>
        <translation>Restzeit unbekannt</translation>
    </message>
</context>
<context>
    <name>footfall::ui::RecentFiles</name>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>(none yet)</source>
        <translation>(noch keine)</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ReplaceTexts</name>
    <message>
        <source>Replace a file</source>
        <translation>Eine Datei ersetzen</translation>
    </message>
    <message>
        <source>Replace %1?</source>
        <translation>%1 ersetzen?</translation>
    </message>
    <message>
        <source>This file is in %1 (%2, last changed %3). Its content will be lost.</source>
        <translation>Diese Datei liegt in %1 (%2, zuletzt geändert %3). Ihr Inhalt geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Replace up to %1 files?</source>
        <translation>Bis zu %1 Dateien ersetzen?</translation>
    </message>
    <message>
        <source>They are in %1: %2. Their content will be lost.</source>
        <translation>Sie liegen in %1: %2. Ihr Inhalt geht verloren.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ResultExport</name>
    <message>
        <source>%1: not written, as the run was cancelled; export again</source>
        <translation>%1: nicht geschrieben, weil der Lauf abgebrochen wurde; exportieren Sie noch einmal</translation>
    </message>
    <message>
        <source>%1: not written, as another environment was opened; open the one before and export again</source>
        <translation>%1: nicht geschrieben, weil eine andere Umgebung geöffnet wurde; öffnen Sie die vorige, und exportieren Sie noch einmal</translation>
    </message>
    <message>
        <source>nothing to export; open an environment first</source>
        <translation>Es gibt nichts zu exportieren; öffnen Sie zuerst eine Umgebung</translation>
    </message>
    <message>
        <source>%1 is written once the run has finished</source>
        <translation>%1 wird geschrieben, sobald der Lauf beendet ist</translation>
    </message>
    <message>
        <source>%1: a picture of %2 × %3 cannot be drawn here; choose a smaller size</source>
        <translation>%1: Ein Bild von %2 × %3 kann hier nicht gezeichnet werden; wählen Sie eine kleinere Größe</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>&amp;Noch einmal exportieren</translation>
    </message>
    <message>
        <source>Write to the file of the last export, with the same options</source>
        <translation>In die Datei des letzten Exports schreiben, mit denselben Einstellungen</translation>
    </message>
    <message>
        <source>Export after each r&amp;un</source>
        <translation>Nach jedem La&amp;uf exportieren</translation>
    </message>
    <message>
        <source>Write every new result to the file of the last export, for another program that watches it</source>
        <translation>Jedes neue Ergebnis in die Datei des letzten Exports schreiben, für ein anderes Programm, das sie beobachtet</translation>
    </message>
    <message>
        <source>&amp;Floor plan...</source>
        <translation>&amp;Grundriss...</translation>
    </message>
    <message>
        <source>Draw plans of the storeys or layers to scale, as PDF or SVG</source>
        <translation>Grundrisse der Geschosse oder Ebenen im Maßstab zeichnen, als PDF oder SVG</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ResultSummary</name>
    <message>
        <source>walkable triangle</source>
        <translation>begehbares Dreieck</translation>
    </message>
    <message>
        <source>walkable triangles</source>
        <translation>begehbare Dreiecke</translation>
    </message>
    <message>
        <source>area %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>obstacle edge</source>
        <translation>Hinderniskante</translation>
    </message>
    <message>
        <source>obstacle edges</source>
        <translation>Hinderniskanten</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>drop</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>drops</source>
        <translation>Sprünge</translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunController</name>
    <message>
        <source>memory ran out; close other programs or use a smaller environment</source>
        <translation>der Speicher ist ausgegangen; schließen Sie andere Programme oder nehmen Sie eine kleinere Umgebung</translation>
    </message>
    <message>
        <source>%1 of %2 cells finished</source>
        <translation>%1 von %2 Zellen fertig</translation>
    </message>
    <message>
        <source>Putting the cells together</source>
        <translation>Zellen werden zusammengefügt</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Abschluss</translation>
    </message>
    <message>
        <source>%1 of 1 cell finished</source>
        <translation>%1 von 1 Zelle fertig</translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunLog</name>
    <message>
        <source>The run was cancelled</source>
        <translation>Der Lauf wurde abgebrochen</translation>
    </message>
    <message numerus="yes">
        <source>Opened %1: %n triangle(s)</source>
        <translation>
            <numerusform>%1 geöffnet: %n Dreieck</numerusform>
            <numerusform>%1 geöffnet: %n Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>What was opened, run and written, and all errors</source>
        <translation>Was geöffnet, ausgeführt und geschrieben wurde, und alle Fehler</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>Protokoll speichern</translation>
    </message>
    <message>
        <source>Text files (*.txt);;All files (*)</source>
        <translation>Textdateien (*.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Run finished: %1</source>
        <translation>Lauf beendet: %1</translation>
    </message>
    <message>
        <source>%1: %2 ms</source>
        <translation>%1: %2 ms</translation>
    </message>
    <message>
        <source>, %1 → 1 triangle</source>
        <translation>, %1 → 1 Dreieck</translation>
    </message>
    <message>
        <source>, %1 → %2 triangles</source>
        <translation>, %1 → %2 Dreiecke</translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunPlaceDialog</name>
    <message>
        <source>Run on: %1</source>
        <translation>Rechnen auf: %1</translation>
    </message>
    <message>
        <source>Machines, a process each:</source>
        <translation>Rechner, je ein Prozess:</translation>
    </message>
    <message>
        <source>Processes:</source>
        <translation>Prozesse:</translation>
    </message>
    <message>
        <source>Host file:</source>
        <translation>Rechnerliste:</translation>
    </message>
    <message>
        <source>Slurm&apos;s default</source>
        <translation>Vorgabe von Slurm</translation>
    </message>
    <message>
        <source>Partition:</source>
        <translation>Partition:</translation>
    </message>
    <message>
        <source>Folder that all machines share:</source>
        <translation>Gemeinsamer Ordner aller Rechner:</translation>
    </message>
    <message>
        <source>Jobs stay there while they run, and are removed at the end</source>
        <translation>Aufträge liegen dort, solange sie laufen, und werden am Ende entfernt</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen...</translation>
    </message>
    <message>
        <source>%1 is not a folder; give one that all machines share</source>
        <translation>%1 ist kein Ordner; geben Sie einen an, den alle Rechner gemeinsam haben</translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunPlaces</name>
    <message>
        <source>This program</source>
        <translation>Dieses Programm</translation>
    </message>
    <message>
        <source>Processes of this machine</source>
        <translation>Prozesse dieses Rechners</translation>
    </message>
    <message>
        <source>Machines of a host file</source>
        <translation>Rechner einer Liste</translation>
    </message>
    <message>
        <source>Machines of Slurm</source>
        <translation>Rechner von Slurm</translation>
    </message>
    <message>
        <source>Where the cells of a run are computed; the result does not depend on it</source>
        <translation>Wo die Zellen eines Laufs berechnet werden; das Ergebnis hängt nicht davon ab</translation>
    </message>
    <message numerus="yes">
        <source>%n process(es) here</source>
        <translation>
            <numerusform>%n Prozess hier</numerusform>
            <numerusform>%n Prozesse hier</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n process(es) of %1</source>
        <translation>
            <numerusform>%n Prozess aus %1</numerusform>
            <numerusform>%n Prozesse aus %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n machine(s) of Slurm</source>
        <translation>
            <numerusform>%n Rechner von Slurm</numerusform>
            <numerusform>%n Rechner von Slurm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n machine(s) of %1</source>
        <translation>
            <numerusform>%n Rechner von %1</numerusform>
            <numerusform>%n Rechner von %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::RunThreads</name>
    <message>
        <source>All threads (%1)</source>
        <translation>Alle Threads (%1)</translation>
    </message>
    <message>
        <source>1 thread</source>
        <translation>1 Thread</translation>
    </message>
    <message>
        <source>%1 threads</source>
        <translation>%1 Threads</translation>
    </message>
    <message>
        <source>The largest number of threads of a run; the result does not depend on it</source>
        <translation>Die größte Zahl der Threads eines Laufs; das Ergebnis hängt nicht davon ab</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ScaleText</name>
    <message>
        <source>1 m</source>
        <translation>1 m</translation>
    </message>
    <message>
        <source>1 cm</source>
        <translation>1 cm</translation>
    </message>
    <message>
        <source>1 mm</source>
        <translation>1 mm</translation>
    </message>
    <message>
        <source>1 inch</source>
        <translation>1 Zoll</translation>
    </message>
    <message>
        <source>1 foot</source>
        <translation>1 Fuß</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>1 unit = %1?</source>
        <translation>1 Einheit = %1?</translation>
    </message>
    <message>
        <source>%1 m high: is 1 unit = %2?</source>
        <translation>%1 m hoch: Ist 1 Einheit = %2?</translation>
    </message>
    <message>
        <source>%1 m long: is 1 unit = %2?</source>
        <translation>%1 m lang: Ist 1 Einheit = %2?</translation>
    </message>
    <message>
        <source>Most steps are %1 high: is 1 unit = %2?</source>
        <translation>Die meisten Stufen sind %1 hoch: ist 1 Einheit = %2?</translation>
    </message>
    <message>
        <source>Doorways are %1 high: is 1 unit = %2?</source>
        <translation>Türen sind %1 hoch: ist 1 Einheit = %2?</translation>
    </message>
    <message>
        <source>Most walls are %1 high: is 1 unit = %2?</source>
        <translation>Die meisten Wände sind %1 hoch: ist 1 Einheit = %2?</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SeedFeature</name>
    <message>
        <source>&amp;Place seeds</source>
        <translation>Start&amp;punkte setzen</translation>
    </message>
    <message>
        <source>Click the places where agents start; everything that they cannot reach is removed</source>
        <translation>Klicken Sie auf die Stellen, an denen Agenten beginnen; was sie nicht erreichen, wird entfernt</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SeedTool</name>
    <message>
        <source>Place seeds: click where agents start. Esc ends.</source>
        <translation>Startpunkte setzen: Klicken Sie, wo Agenten beginnen. Esc beendet.</translation>
    </message>
    <message>
        <source>Place seeds: click to add one, drag one to move it, Ctrl and a click remove it. Esc ends.</source>
        <translation>Startpunkte setzen: Ein Klick fügt einen hinzu, Ziehen verschiebt ihn, Strg und Klick entfernt ihn. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SelectObstacleTool</name>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Resize %1</source>
        <translation>Größe von %1 ändern</translation>
    </message>
    <message>
        <source>Click an obstacle; drag its handles to move, turn and resize it. Shift snaps, Alt drags a copy, Esc takes back</source>
        <translation>Hindernis anklicken; seine Griffe ziehen, um es zu bewegen, zu drehen und seine Größe zu ändern. Umschalt rastet ein, Alt zieht eine Kopie, Esc nimmt zurück</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SeparationMend</name>
    <message>
        <source>Lower %1 to %2</source>
        <translation>%1 auf %2 senken</translation>
    </message>
    <message>
        <source>Raise %1 to %2</source>
        <translation>%1 auf %2 erhöhen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SeparationText</name>
    <message>
        <source>The parts are nearest at %1: %2.</source>
        <translation>Am nächsten sind sich die Teile bei %1: %2.</translation>
    </message>
    <message numerus="yes">
        <source>It is the largest of %n obstacles on the easiest way.</source>
        <translation>
            <numerusform>Es ist das einzige Hindernis auf dem leichtesten Weg.</numerusform>
            <numerusform>Es ist das größte von %n Hindernissen auf dem leichtesten Weg.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other ways lack little more.</source>
        <translation>
            <numerusform>Einem weiteren Weg fehlt nur wenig mehr.</numerusform>
            <numerusform>%n weiteren Wegen fehlt nur wenig mehr.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::SeparationView</name>
    <message>
        <source>Show &amp;it</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>The obstacle between start and target</source>
        <translation>Das Hindernis zwischen Start und Ziel</translation>
    </message>
    <message>
        <source>Bring the place into sight where the two parts are nearest to each other</source>
        <translation>Die Stelle ins Bild bringen, an der sich die beiden Teile am nächsten sind</translation>
    </message>
    <message>
        <source>Change the filter so that this place can be passed; undo takes it back</source>
        <translation>Ändert den Filter, so dass man dort durchkommt; Rückgängig nimmt es zurück</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SessionFiles</name>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.%1)</source>
        <translation>Sitzungen (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes as a session?</source>
        <translation>Die Änderungen als Sitzung speichern?</translation>
    </message>
    <message>
        <source>Save the changes to the session %1?</source>
        <translation>Die Änderungen in der Sitzung %1 speichern?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Filters, agents, obstacles and settings of %1 have changed, and are lost otherwise. The file %1 itself stays as it is.</source>
        <translation>Filter, Agenten, Hindernisse und Einstellungen von %1 haben sich geändert und gehen sonst verloren. Die Datei %1 selbst bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Footfall ended unexpectedly while %1 was open (last change %2). Restore the session?</source>
        <translation>Footfall wurde unerwartet beendet, während %1 geöffnet war (letzte Änderung %2). Die Sitzung wiederherstellen?</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Footfall ended unexpectedly, and %1 sessions were not closed. Restore %2 (last change %3)?</source>
        <translation>Footfall wurde unerwartet beendet, und %1 Sitzungen waren offen. %2 wiederherstellen (letzte Änderung %3)?</translation>
    </message>
    <message>
        <source>Others...</source>
        <translation>Andere...</translation>
    </message>
    <message>
        <source>%1, last change %2</source>
        <translation>%1, letzte Änderung %2</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SessionKeeper</name>
    <message>
        <source>%1: the session cannot be saved for recovery after a crash; make this folder writable</source>
        <translation>%1: Die Sitzung kann nicht zur Wiederherstellung nach einem Absturz gespeichert werden; machen Sie diesen Ordner beschreibbar</translation>
    </message>
    <message>
        <source>The session cannot be saved for recovery after a crash: %1</source>
        <translation>Die Sitzung kann nicht zur Wiederherstellung nach einem Absturz gespeichert werden: %1</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SessionSections</name>
    <message>
        <source>session, &apos;%1&apos;: %2; this part was left out</source>
        <translation>Sitzung, „%1“: %2; dieser Teil wurde ausgelassen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ShareBar</name>
    <message>
        <source>%1 % of the time of all filters</source>
        <translation>%1 % der Zeit aller Filter</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ShortcutWindow</name>
    <message>
        <source>Left drag</source>
        <translation>Links ziehen</translation>
    </message>
    <message>
        <source>Turn about the pivot</source>
        <translation>Um den Drehpunkt drehen</translation>
    </message>
    <message>
        <source>Right or middle drag, Shift+left drag</source>
        <translation>Rechts oder mitte ziehen, Umschalt+links ziehen</translation>
    </message>
    <message>
        <source>Move sideways</source>
        <translation>Seitwärts verschieben</translation>
    </message>
    <message>
        <source>Wheel, Ctrl+left drag</source>
        <translation>Rad, Strg+links ziehen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Turn about this place from now on</source>
        <translation>Von nun an um diese Stelle drehen</translation>
    </message>
    <message>
        <source>Click on a cell</source>
        <translation>Klick auf eine Zelle</translation>
    </message>
    <message>
        <source>Select it and bring it into sight</source>
        <translation>Sie auswählen und ins Bild bringen</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Move sideways (in the view)</source>
        <translation>Seitwärts verschieben (in der Ansicht)</translation>
    </message>
    <message>
        <source>Alt+Up, Alt+Down</source>
        <translation>Alt+Auf, Alt+Ab</translation>
    </message>
    <message>
        <source>Move a filter in the list</source>
        <translation>Einen Filter in der Liste verschieben</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Auf, Ab</translation>
    </message>
    <message>
        <source>Change the value of a field by a small step</source>
        <translation>Den Wert eines Felds um einen kleinen Schritt ändern</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>Next and previous control</source>
        <translation>Nächstes und voriges Bedienelement</translation>
    </message>
    <message>
        <source>F10, Alt</source>
        <translation>F10, Alt</translation>
    </message>
    <message>
        <source>The menus</source>
        <translation>Die Menüs</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>End a tool, cancel a run, restore a field&apos;s value</source>
        <translation>Ein Werkzeug beenden, einen Lauf abbrechen, den Wert eines Felds wiederherstellen</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>Nach einem Befehl oder einer Taste suchen</translation>
    </message>
    <message>
        <source>Show rows with this text</source>
        <translation>Zeilen mit diesem Text zeigen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was er tut</translation>
    </message>
    <message>
        <source>%1, without keys</source>
        <translation>%1, ohne Tasten</translation>
    </message>
    <message>
        <source>Mouse, view and fields</source>
        <translation>Maus, Ansicht und Felder</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SideBySide</name>
    <message>
        <source>View of pipeline B</source>
        <translation>Ansicht der Pipeline B</translation>
    </message>
    <message>
        <source>Two Pipelines Side by Side</source>
        <translation>Zwei Pipelines nebeneinander</translation>
    </message>
    <message>
        <source>Keep the filters as they are as B, beside the list that you go on editing as A</source>
        <translation>Die Filter, wie sie sind, als B behalten, neben der Liste, die Sie als A weiter bearbeiten</translation>
    </message>
    <message>
        <source>the filters as they were</source>
        <translation>die Filter, wie sie waren</translation>
    </message>
    <message>
        <source>B is being computed …</source>
        <translation>B wird berechnet …</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B: %1</translation>
    </message>
    <message>
        <source>The filters as they are</source>
        <translation>Die Filter, wie sie sind</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>A pipeline file…</source>
        <translation>Eine Pipeline-Datei…</translation>
    </message>
    <message>
        <source>A pipeline for B</source>
        <translation>Eine Pipeline für B</translation>
    </message>
    <message>
        <source>Pipelines (*.pipeline)</source>
        <translation>Pipelines (*.pipeline)</translation>
    </message>
    <message>
        <source>Swap the pipelines A and B</source>
        <translation>Die Pipelines A und B tauschen</translation>
    </message>
    <message>
        <source>the list before the swap</source>
        <translation>die Liste vor dem Tausch</translation>
    </message>
    <message>
        <source>Keep pipeline B</source>
        <translation>Pipeline B behalten</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SideBySideBar</name>
    <message>
        <source>Walkable area</source>
        <translation>Begehbare Fläche</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>&lt;b&gt;A&lt;/b&gt; the list of filters</source>
        <translation>&lt;b&gt;A&lt;/b&gt; die Liste der Filter</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>&amp;Swap</source>
        <translation>&amp;Tauschen</translation>
    </message>
    <message>
        <source>Edit B: its filters become the list, and the list becomes B</source>
        <translation>B bearbeiten: Seine Filter werden zur Liste, und die Liste wird zu B</translation>
    </message>
    <message>
        <source>Keep &amp;A</source>
        <translation>&amp;A behalten</translation>
    </message>
    <message>
        <source>End side by side; the list of filters stays as it is</source>
        <translation>Nebeneinander beenden; die Liste der Filter bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Keep &amp;B</source>
        <translation>&amp;B behalten</translation>
    </message>
    <message>
        <source>End side by side; the list of filters becomes B&apos;s (can be undone)</source>
        <translation>Nebeneinander beenden; die Liste der Filter wird die von B (lässt sich rückgängig machen)</translation>
    </message>
    <message>
        <source>B is…</source>
        <translation>B ist…</translation>
    </message>
    <message>
        <source>Choose the filters that B shows</source>
        <translation>Wählen, welche Filter B zeigt</translation>
    </message>
</context>
<context>
    <name>footfall::ui::SkippedFeature</name>
    <message>
        <source>Left Out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>List the polygons of the file that could not be read as floors or walls, and why</source>
        <translation>Die Polygone der Datei aufführen, die nicht als Boden oder Wand gelesen werden konnten, und warum</translation>
    </message>
    <message>
        <source>List the polygons of the file that were left out, and why</source>
        <translation>Die Polygone der Datei aufführen, die weggelassen wurden, und warum</translation>
    </message>
    <message>
        <source>This polygon has no corners: it is nowhere in the level.</source>
        <translation>Dieses Polygon hat keine Ecken: Es liegt nirgends im Level.</translation>
    </message>
    <message numerus="yes">
        <source>%n polygons left out: show them</source>
        <translation>
            <numerusform>%n Polygon ausgelassen: zeigen</numerusform>
            <numerusform>%n Polygone ausgelassen: zeigen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::SkippedPanel</name>
    <message>
        <source>Polygons of the file that were left out</source>
        <translation>Polygone der Datei, die weggelassen wurden</translation>
    </message>
    <message>
        <source>Click a polygon, or press Return on it, to bring its corners into sight</source>
        <translation>Klick auf ein Polygon oder Eingabe darauf bringt seine Ecken ins Bild</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nirgends</translation>
    </message>
    <message>
        <source>No polygon of the file was left out.</source>
        <translation>Kein Polygon der Datei wurde weggelassen.</translation>
    </message>
    <message numerus="yes">
        <source>%n polygons of the file were left out:</source>
        <translation>
            <numerusform>%n Polygon der Datei wurde weggelassen:</numerusform>
            <numerusform>%n Polygone der Datei wurden weggelassen:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n are listed.</source>
        <translation>
            <numerusform>Das erste ist aufgeführt.</numerusform>
            <numerusform>Die ersten %n sind aufgeführt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::StaleBadge</name>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Out of date: the filters have changed</source>
        <translation>Veraltet: Die Filter haben sich geändert</translation>
    </message>
    <message>
        <source>Run (F5)</source>
        <translation>Ausführen (F5)</translation>
    </message>
    <message>
        <source>Run the filters as they are now</source>
        <translation>Die Filter ausführen, wie sie jetzt sind</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ThemeCommands</name>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>Theme: as the &amp;system</source>
        <translation>Farbschema: wie das &amp;System</translation>
    </message>
    <message>
        <source>Light or dark, as the desktop is, and with it when it changes</source>
        <translation>Hell oder dunkel wie die Arbeitsumgebung, und mit ihr, wenn sie wechselt</translation>
    </message>
    <message>
        <source>Theme: &amp;light</source>
        <translation>Farbschema: &amp;hell</translation>
    </message>
    <message>
        <source>Dark text on light ground</source>
        <translation>Dunkler Text auf hellem Grund</translation>
    </message>
    <message>
        <source>Theme: &amp;dark</source>
        <translation>Farbschema: &amp;dunkel</translation>
    </message>
    <message>
        <source>Light text on dark ground</source>
        <translation>Heller Text auf dunklem Grund</translation>
    </message>
</context>
<context>
    <name>footfall::ui::TimeStrip</name>
    <message>
        <source>Time of the filters</source>
        <translation>Zeit der Filter</translation>
    </message>
    <message>
        <source>&lt;p&gt;What a run without the cache takes: each filter when it was last computed.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Was ein Lauf ohne Zwischenspeicher braucht: jeder Filter, als er zuletzt berechnet wurde.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>footfall::ui::TimelineLanes</name>
    <message>
        <source>partitioning</source>
        <translation>Aufteilung</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>merging</source>
        <translation>Zusammenfügen</translation>
    </message>
    <message>
        <source>first state</source>
        <translation>erster Zustand</translation>
    </message>
    <message>
        <source>between the steps</source>
        <translation>zwischen den Schritten</translation>
    </message>
    <message>
        <source>navigation mesh</source>
        <translation>Navigationsnetz</translation>
    </message>
</context>
<context>
    <name>footfall::ui::TimelinePlot</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitachse</translation>
    </message>
    <message>
        <source>A lane for each thread, with a bar for each cell that it worked on</source>
        <translation>Eine Spur für jeden Thread, mit einem Balken für jede Zelle, an der er gearbeitet hat</translation>
    </message>
    <message>
        <source>estimated work (units), the largest cells first</source>
        <translation>geschätzte Arbeit (Einheiten), die größten Zellen zuerst</translation>
    </message>
    <message>
        <source>time since the run began (ms)</source>
        <translation>Zeit seit Beginn des Laufs (ms)</translation>
    </message>
    <message>
        <source>Whole environment</source>
        <translation>Ganze Umgebung</translation>
    </message>
    <message>
        <source>Here %1&lt;br&gt;on thread %2, %3 to %4 ms</source>
        <translation>Hier %1&lt;br&gt;auf Thread %2, %3 bis %4 ms</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Thread %1 was idle for %2</source>
        <translation>Thread %1 war %2 lang untätig</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>It waited for work: other threads had the last cells.</source>
        <translation>Er wartete auf Arbeit: andere Threads hatten die letzten Zellen.</translation>
    </message>
    <message>
        <source>Busy threads: %1 of %2</source>
        <translation>Beschäftigte Threads: %1 von %2</translation>
    </message>
    <message>
        <source>The others waited for it: %1 of thread time</source>
        <translation>Die anderen warteten darauf: %1 Threadzeit</translation>
    </message>
    <message>
        <source>Other programs had the processors for %1 of the thread time that this part could have used</source>
        <translation>Andere Programme hatten die Prozessoren für %1 der Threadzeit, die dieser Teil hätte nutzen können</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ToolBars</name>
    <message>
        <source>Files and view</source>
        <translation>Dateien und Ansicht</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>footfall::ui::Turntable</name>
    <message>
        <source>%1: %2 of %3 frames are written, as the filters run again; start the turntable anew after the run</source>
        <translation>%1: %2 von %3 Bildern sind geschrieben, denn die Filter laufen noch einmal; beginnen Sie den Drehteller nach dem Lauf von vorn</translation>
    </message>
    <message>
        <source>there is no result to show yet; open an environment and wait for the run</source>
        <translation>Es gibt noch kein Ergebnis zu zeigen; öffnen Sie eine Umgebung und warten Sie auf den Lauf</translation>
    </message>
    <message>
        <source>the turntable needs a folder; name one</source>
        <translation>Der Drehteller braucht einen Ordner; nennen Sie einen</translation>
    </message>
    <message>
        <source>%1: is a file; name a folder</source>
        <translation>%1: ist eine Datei; nennen Sie einen Ordner</translation>
    </message>
    <message>
        <source>%1: has frames of another sequence; name another folder, or remove them</source>
        <translation>%1: hat Bilder einer anderen Folge; nennen Sie einen anderen Ordner, oder entfernen Sie sie</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made; name one in a place that you may write to</source>
        <translation>%1: Der Ordner lässt sich nicht anlegen; nennen Sie einen, wo Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>frames of %1 × %2 cannot be drawn here; choose a smaller size</source>
        <translation>Bilder von %1 × %2 lassen sich hier nicht zeichnen; wählen Sie eine kleinere Größe</translation>
    </message>
    <message>
        <source>%1. %2 of %3 frames are written</source>
        <translation>%1. %2 von %3 Bildern sind geschrieben</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frames are written, as the turntable was cancelled</source>
        <translation>%1: %2 von %3 Bildern sind geschrieben, denn der Drehteller wurde abgebrochen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::TurntableDialog</name>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Writes pictures of the result from all around, as a sequence of PNG files (frame_0001.png and so on). The first one looks as the view does now.</source>
        <translation>Schreibt Bilder des Ergebnisses von rundum, als Folge von PNG-Dateien (frame_0001.png und so fort). Das erste blickt, wie die Ansicht jetzt blickt.</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>D&amp;urchsuchen...</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>&amp;Bilder</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>A folder for the frames</source>
        <translation>Ein Ordner für die Bilder</translation>
    </message>
    <message>
        <source>%1 s at %2 frames a second</source>
        <translation>%1 s bei %2 Bildern je Sekunde</translation>
    </message>
</context>
<context>
    <name>footfall::ui::TurntableFeature</name>
    <message>
        <source>&amp;Turntable...</source>
        <translation>&amp;Drehteller...</translation>
    </message>
    <message>
        <source>Write pictures from all around the level, as a sequence of PNG files</source>
        <translation>Bilder rund um das Level schreiben, als Folge von PNG-Dateien</translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n frames to %1</source>
        <translation>
            <numerusform>%n Bild nach %1 geschrieben</numerusform>
            <numerusform>%n Bilder nach %1 geschrieben</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>footfall::ui::ViewHint</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Do not show this again</source>
        <translation>Nicht mehr zeigen</translation>
    </message>
</context>
<context>
    <name>footfall::ui::ViewModes</name>
    <message>
        <source>View mode</source>
        <translation>Ansichtsart</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Was die Ansicht zeigt</translation>
    </message>
    <message>
        <source>Open an environment first</source>
        <translation>Öffnen Sie zuerst eine Umgebung</translation>
    </message>
    <message>
        <source>Waits for the first result of the filters</source>
        <translation>Wartet auf das erste Ergebnis der Filter</translation>
    </message>
    <message>
        <source>view: memory ran out; choose another view mode or a smaller environment</source>
        <translation>Ansicht: Der Speicher reicht nicht; wählen Sie eine andere Ansichtsart oder eine kleinere Umgebung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::WalkBar</name>
    <message>
        <source>Time on the way</source>
        <translation>Zeit auf dem Weg</translation>
    </message>
    <message>
        <source>Where the walker is on the path</source>
        <translation>Wo auf dem Weg die Figur ist</translation>
    </message>
    <message>
        <source>Pace of the playback</source>
        <translation>Tempo der Wiedergabe</translation>
    </message>
    <message>
        <source>How fast the walk is played</source>
        <translation>Wie schnell der Gang abgespielt wird</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Camera of the walker</source>
        <translation>Kamera der Figur</translation>
    </message>
    <message>
        <source>Where the camera is while the walker goes</source>
        <translation>Wo die Kamera ist, während die Figur geht</translation>
    </message>
    <message>
        <source>Camera stays</source>
        <translation>Kamera bleibt</translation>
    </message>
    <message>
        <source>Camera follows</source>
        <translation>Kamera folgt</translation>
    </message>
    <message>
        <source>Through its eyes</source>
        <translation>Durch ihre Augen</translation>
    </message>
    <message>
        <source>Pause (Space in the view)</source>
        <translation>Anhalten (Leertaste in der Ansicht)</translation>
    </message>
    <message>
        <source>Walk the path (Space in the view)</source>
        <translation>Den Weg gehen (Leertaste in der Ansicht)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Walk the path</source>
        <translation>Den Weg gehen</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
</context>
<context>
    <name>footfall::ui::WalkFeature</name>
    <message>
        <source>Wal&amp;k</source>
        <translation>&amp;Gehen</translation>
    </message>
    <message>
        <source>Walk over the result in first person, as tall as the agent</source>
        <translation>Über das Ergebnis gehen, mit den Augen des Agenten</translation>
    </message>
    <message>
        <source>Walk the pat&amp;h</source>
        <translation>Den We&amp;g gehen</translation>
    </message>
    <message>
        <source>Let somebody of the agent&apos;s size walk the path of Try it</source>
        <translation>Eine Figur von der Größe des Agenten geht den Weg, der ausprobiert wird</translation>
    </message>
</context>
<context>
    <name>footfall::ui::WalkTool</name>
    <message>
        <source>Walk: nothing is walkable here. Esc ends.</source>
        <translation>Gehen: Hier ist nichts begehbar. Esc beendet.</translation>
    </message>
    <message>
        <source>Walk: W A S D or the arrows walk, the mouse looks, Shift is faster, Esc leaves.</source>
        <translation>Gehen: W A S D oder die Pfeile gehen, die Maus sieht sich um, Umschalt schneller, Esc beendet.</translation>
    </message>
    <message>
        <source>Walk: click where to stand, or press Enter for the middle of the view. Esc ends.</source>
        <translation>Gehen: Klicken Sie, wo Sie stehen wollen, oder Eingabe für die Mitte der Ansicht. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>footfall::ui::Welcome</name>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Willkommen</translation>
    </message>
    <message>
        <source>Samples, recent files and the last session</source>
        <translation>Beispiele, zuletzt geöffnete Dateien und die letzte Sitzung</translation>
    </message>
</context>
<context>
    <name>footfall::ui::WelcomePage</name>
    <message>
        <source>House</source>
        <translation>Haus</translation>
    </message>
    <message>
        <source>820 triangles: ramps, an overhang, walls without thickness</source>
        <translation>820 Dreiecke: Rampen, ein Überhang, Wände ohne Dicke</translation>
    </message>
    <message>
        <source>Villa</source>
        <translation>Villa</translation>
    </message>
    <message>
        <source>30,000 triangles: three furnished storeys on rough ground</source>
        <translation>30.000 Dreiecke: drei möblierte Stockwerke auf unebenem Gelände</translation>
    </message>
    <message>
        <source>Arena</source>
        <translation>Arena</translation>
    </message>
    <message>
        <source>20,000 triangles: a stadium with steps and a ring road on pillars</source>
        <translation>20.000 Dreiecke: ein Stadion mit Stufen und einer Ringstraße auf Pfeilern</translation>
    </message>
    <message>
        <source>Docks</source>
        <translation>Hafen</translation>
    </message>
    <message>
        <source>59,000 triangles: ships, piers, crates and ropes</source>
        <translation>59.000 Dreiecke: Schiffe, Piere, Kisten und Taue</translation>
    </message>
    <message>
        <source>Tower</source>
        <translation>Turm</translation>
    </message>
    <message>
        <source>440 triangles: 26 storeys, one above the other</source>
        <translation>440 Dreiecke: 26 Stockwerke, eins über dem anderen</translation>
    </message>
    <message>
        <source>The exact walkable area of 3D environments</source>
        <translation>Die exakte begehbare Fläche von 3D-Umgebungen</translation>
    </message>
    <message>
        <source>Back to the view (Esc)</source>
        <translation>Zurück zur Ansicht (Esc)</translation>
    </message>
    <message>
        <source>Back to the view</source>
        <translation>Zurück zur Ansicht</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>Open an environment or a session (Ctrl+O)</source>
        <translation>Eine Umgebung oder eine Sitzung öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>or drop a file anywhere in this window</source>
        <translation>oder lassen Sie eine Datei irgendwo in diesem Fenster fallen</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Enter opens a file, Delete removes it from the list</source>
        <translation>Die Eingabetaste öffnet eine Datei, Entf entfernt sie von der Liste</translation>
    </message>
    <message>
        <source>Files that you open are listed here.</source>
        <translation>Dateien, die Sie öffnen, stehen hier.</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Von der Liste entfernen</translation>
    </message>
    <message>
        <source>Forget this file; the file itself stays</source>
        <translation>Diese Datei vergessen; die Datei selbst bleibt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Sample %1</source>
        <translation>Beispiel %1</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>Continue the last session: %1</source>
        <translation>Letzte Sitzung fortsetzen: %1</translation>
    </message>
    <message>
        <source>As it was left on %1</source>
        <translation>Wie sie am %1 verlassen wurde</translation>
    </message>
    <message>
        <source>Rooms</source>
        <translation>Räume</translation>
    </message>
    <message>
        <source>266 triangles: the tour&apos;s level, with a doorway that is too low</source>
        <translation>266 Dreiecke: das Level der Tour, mit einem zu niedrigen Durchgang</translation>
    </message>
</context>
<context>
    <name>footfall::ui::WhyPanel</name>
    <message>
        <source>Choose Tools &gt; Why? (Y) and click a place in the view: this panel then says why it is walkable, or which filter rejected it and what stands in the way.</source>
        <translation>Wählen Sie Werkzeuge &gt; Warum? (Y) und klicken Sie eine Stelle in der Ansicht an: Diese Tafel sagt dann, warum sie begehbar ist, oder welcher Filter sie verworfen hat und was im Weg steht.</translation>
    </message>
    <message>
        <source>Its colour in the view</source>
        <translation>Seine Farbe in der Ansicht</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Counted from 0 in the order of the file, without ignored parts; with the names of mesh and material</source>
        <translation>Von 0 an in der Reihenfolge der Datei gezählt, ohne weggelassene Teile; mit den Namen von Netz und Material</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Between the upper side of the triangle and the horizontal; beyond 90° it faces down</source>
        <translation>Zwischen der Oberseite des Dreiecks und der Waagerechten; über 90° zeigt es nach unten</translation>
    </message>
    <message>
        <source>Free height</source>
        <translation>Freie Höhe</translation>
    </message>
    <message>
        <source>Up to the lowest triangle straight above</source>
        <translation>Bis zum niedrigsten Dreieck senkrecht darüber</translation>
    </message>
    <message>
        <source>Go to the filter that rejected this place, in the list</source>
        <translation>Zum Filter gehen, der diese Stelle verworfen hat, in der Liste</translation>
    </message>
    <message>
        <source>Frame the &amp;obstacle</source>
        <translation>&amp;Hindernis ins Bild</translation>
    </message>
    <message>
        <source>Bring what stands in the way into sight</source>
        <translation>Was im Weg steht, ins Bild bringen</translation>
    </message>
    <message>
        <source>Frame the &amp;place</source>
        <translation>&amp;Stelle ins Bild</translation>
    </message>
    <message>
        <source>Bring the triangle into sight</source>
        <translation>Das Dreieck ins Bild bringen</translation>
    </message>
    <message>
        <source>Go to step %1: %2</source>
        <translation>Zu Schritt %1: %2</translation>
    </message>
    <message>
        <source>Borders</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>How far the nearest wall and the nearest ledge are, straight over the walkable area as it is before a radius narrows it, seen from above</source>
        <translation>Wie weit die nächste Wand und die nächste Kante sind, geradeaus über die begehbare Fläche, wie sie ist, bevor ein Radius sie verengt, von oben gesehen</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
</context>
<context>
    <name>footfall::ui::WindowClosing</name>
    <message>
        <source>Saving the file. Footfall closes when it is done; close again to close now</source>
        <translation>Die Datei wird gespeichert. Danach schließt sich Footfall; erneutes Schließen schließt sofort</translation>
    </message>
    <message>
        <source>Not written yet</source>
        <translation>Noch nicht geschrieben</translation>
    </message>
    <message>
        <source>%1 waits for the run.</source>
        <translation>%1 wartet auf den Lauf.</translation>
    </message>
    <message>
        <source>&amp;Write, then close</source>
        <translation>&amp;Schreiben, dann schließen</translation>
    </message>
    <message>
        <source>Close &amp;without it</source>
        <translation>&amp;Ohne sie schließen</translation>
    </message>
</context>
</TS>
