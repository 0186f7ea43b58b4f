<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk_UA">
<context>
    <name>CoefficientText</name>
    <message>
        <source>ellipse: </source>
        <translation>еліпс: </translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Space</source>
        <translation>Пробіл</translation>
    </message>
</context>
<context>
    <name>parts</name>
    <message>
        <source>bottom line</source>
        <translation>нижній рядок</translation>
    </message>
    <message>
        <source>breakpoints</source>
        <translation>точки зупинки</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>вручну</translation>
    </message>
    <message>
        <source>by hand: grid</source>
        <translation>вручну: сітка</translation>
    </message>
    <message>
        <source>charts</source>
        <translation>діаграми</translation>
    </message>
    <message>
        <source>charts: drawing</source>
        <translation>діаграми: рисунок</translation>
    </message>
    <message>
        <source>compare</source>
        <translation>порівняння</translation>
    </message>
    <message>
        <source>compare: pictures</source>
        <translation>порівняння: зображення</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>карта відстаней</translation>
    </message>
    <message>
        <source>distance: marks</source>
        <translation>карта відстаней: позначки</translation>
    </message>
    <message>
        <source>duel</source>
        <translation>двобій</translation>
    </message>
    <message>
        <source>duel: drawing</source>
        <translation>двобій: рисунок</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>рисунок</translation>
    </message>
    <message>
        <source>footprint</source>
        <translation>проєкція пікселя</translation>
    </message>
    <message>
        <source>footprint: marks</source>
        <translation>проєкція пікселя: позначки</translation>
    </message>
    <message>
        <source>formulas</source>
        <translation>формули</translation>
    </message>
    <message>
        <source>pane</source>
        <translation>панель</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>профіль</translation>
    </message>
    <message>
        <source>profile: marks</source>
        <translation>профіль: позначки</translation>
    </message>
    <message>
        <source>profile: relief</source>
        <translation>профіль: рельєф</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>MIP-піраміда</translation>
    </message>
    <message>
        <source>pyramid in 3-D</source>
        <translation>MIP-піраміда 3D</translation>
    </message>
    <message>
        <source>pyramid: marks</source>
        <translation>MIP-піраміда: позначки</translation>
    </message>
    <message>
        <source>pyramid: marks on slabs</source>
        <translation>MIP-піраміда: позначки на плитах</translation>
    </message>
    <message>
        <source>pyramid: slabs</source>
        <translation>MIP-піраміда: плити</translation>
    </message>
    <message>
        <source>result</source>
        <translation>результат</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>рядки</translation>
    </message>
    <message>
        <source>rows: drawing</source>
        <translation>рядки: рисунок</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>сцена</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>пропущене</translation>
    </message>
    <message>
        <source>step bar</source>
        <translation>панель кроків</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>кроки</translation>
    </message>
    <message>
        <source>top bar</source>
        <translation>верхня панель</translation>
    </message>
    <message>
        <source>trace 3-D</source>
        <translation>трасування 3D</translation>
    </message>
    <message>
        <source>trace 3-D: scene</source>
        <translation>трасування 3D: сцена</translation>
    </message>
    <message>
        <source>trace 3-D: step</source>
        <translation>трасування 3D: крок</translation>
    </message>
    <message>
        <source>doctor</source>
        <translation>діагностика</translation>
    </message>
    <message>
        <source>doctor: drawing</source>
        <translation>діагностика: рисунок</translation>
    </message>
    <message>
        <source>shader</source>
        <translation>шейдер</translation>
    </message>
    <message>
        <source>shader: drawing</source>
        <translation>шейдер: рисунок</translation>
    </message>
    <message>
        <source>watch</source>
        <translation>стеження</translation>
    </message>
    <message>
        <source>why</source>
        <translation>чому такий колір</translation>
    </message>
</context>
<context>
    <name>reliefui::AnnotationDialog</name>
    <message>
        <source>Annotation</source>
        <translation>Позначка</translation>
    </message>
    <message>
        <source>the same text</source>
        <translation>той самий текст</translation>
    </message>
    <message>
        <source>as text</source>
        <translation>як текст</translation>
    </message>
    <message>
        <source>vermilion</source>
        <translation>кіновар</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>помаранчевий</translation>
    </message>
    <message>
        <source>green</source>
        <translation>зелений</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>синій</translation>
    </message>
    <message>
        <source>sky blue</source>
        <translation>блакитний</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>пурпуровий</translation>
    </message>
    <message>
        <source>&amp;Text:</source>
        <translation>&amp;Текст:</translation>
    </message>
    <message>
        <source>In &amp;Ukrainian:</source>
        <translation>&amp;Українською:</translation>
    </message>
    <message>
        <source>&amp;Colour:</source>
        <translation>&amp;Колір:</translation>
    </message>
</context>
<context>
    <name>reliefui::AnnotationLayer</name>
    <message>
        <source>Add an annotation</source>
        <translation>Додавання позначки</translation>
    </message>
    <message>
        <source>Edit an annotation</source>
        <translation>Зміна позначки</translation>
    </message>
    <message>
        <source>Remove an annotation</source>
        <translation>Вилучення позначки</translation>
    </message>
    <message>
        <source>Move an annotation</source>
        <translation>Переміщення позначки</translation>
    </message>
    <message>
        <source>Add an arrow here…</source>
        <translation>Додати тут стрілку…</translation>
    </message>
    <message>
        <source>Add a label here…</source>
        <translation>Додати тут напис…</translation>
    </message>
    <message>
        <source>Add a bracket here…</source>
        <translation>Додати тут дужку…</translation>
    </message>
    <message>
        <source>Add a number here</source>
        <translation>Додати тут номер</translation>
    </message>
    <message>
        <source>Annotate</source>
        <translation>Позначки</translation>
    </message>
    <message>
        <source>Edit the annotation…</source>
        <translation>Змінити позначку…</translation>
    </message>
    <message>
        <source>Remove the annotation</source>
        <translation>Вилучити позначку</translation>
    </message>
</context>
<context>
    <name>reliefui::BookmarkDialog</name>
    <message>
        <source>Bookmarks</source>
        <translation>Закладки</translation>
    </message>
    <message>
        <source>&amp;Go there</source>
        <translation>&amp;Перейти</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Вилучити</translation>
    </message>
    <message>
        <source>Remove bookmark</source>
        <translation>Вилучити закладку</translation>
    </message>
    <message>
        <source>Rename bookmark</source>
        <translation>Перейменувати закладку</translation>
    </message>
    <message>
        <source>Enter goes to the bookmark, F2 renames it</source>
        <translation>Enter переходить до закладки, F2 перейменовує її</translation>
    </message>
</context>
<context>
    <name>reliefui::BookmarkMenu</name>
    <message>
        <source>%1 – pixel (%2, %3), step %4</source>
        <translation>%1 — піксель (%2, %3), крок %4</translation>
    </message>
    <message>
        <source>bookmark %1</source>
        <translation>закладка %1</translation>
    </message>
    <message>
        <source>Add bookmark</source>
        <translation>Додати закладку</translation>
    </message>
</context>
<context>
    <name>reliefui::BreakpointBar</name>
    <message>
        <source>stop when</source>
        <translation>зупинка, коли</translation>
    </message>
    <message>
        <source>Where stepping stops</source>
        <translation>Де зупиняються кроки</translation>
    </message>
    <message>
        <source>level below</source>
        <translation>рівень менший за</translation>
    </message>
    <message>
        <source>texel</source>
        <translation>тексель</translation>
    </message>
    <message>
        <source>ray below</source>
        <translation>промінь нижче</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>проскок</translation>
    </message>
    <message>
        <source>disagreement with exact</source>
        <translation>розбіжність із точним методом</translation>
    </message>
    <message>
        <source>level </source>
        <translation>рівень </translation>
    </message>
    <message>
        <source>Level of the pyramid, 0 the finest</source>
        <translation>Рівень піраміди; 0 — базовий</translation>
    </message>
    <message>
        <source>Column of the texel</source>
        <translation>Стовпець текселя</translation>
    </message>
    <message>
        <source>Row of the texel</source>
        <translation>Рядок текселя</translation>
    </message>
    <message>
        <source>Height of the ray, 1 the top of the slab</source>
        <translation>Висота променя; 1 — верх товщі рельєфу</translation>
    </message>
    <message>
        <source>Add the breakpoint</source>
        <translation>Додати точку зупинки</translation>
    </message>
    <message>
        <source>Add the breakpoint; F9 sets one at the texel of the chosen step</source>
        <translation>Додати точку зупинки; F9 ставить її на текселі вибраного кроку</translation>
    </message>
    <message>
        <source>Add breakpoint</source>
        <translation>Додати точку зупинки</translation>
    </message>
    <message>
        <source>Remove breakpoint</source>
        <translation>Вилучити точку зупинки</translation>
    </message>
    <message>
        <source>Remove the breakpoint: %1</source>
        <translation>Вилучити точку зупинки: %1</translation>
    </message>
    <message>
        <source>Playing and running stop at the first step that meets this condition</source>
        <translation>Відтворення й перехід зупиняються на першому кроці, для якого справджується ця умова</translation>
    </message>
    <message>
        <source>Turn breakpoint on or off</source>
        <translation>Увімкнути чи вимкнути точку зупинки</translation>
    </message>
    <message>
        <source>Stops here; press to turn it off</source>
        <translation>Зупиняє; натисніть, щоб вимкнути</translation>
    </message>
    <message>
        <source>Is off; press to turn it on</source>
        <translation>Вимкнена; натисніть, щоб увімкнути</translation>
    </message>
    <message>
        <source>condition</source>
        <translation>умова</translation>
    </message>
    <message>
        <source>Condition over the columns of the steps</source>
        <translation>Умова над стовпцями кроків</translation>
    </message>
    <message>
        <source>Condition over the columns of the steps and the pixel, such as level == 3 &amp;&amp; delta_lambda &lt; 0.01 or pixel == 480,300; Enter adds it</source>
        <translation>Умова над стовпцями кроків і пікселем, наприклад level == 3 &amp;&amp; delta_lambda &lt; 0.01 або pixel == 480,300; Enter додає її</translation>
    </message>
    <message>
        <source>ignore </source>
        <translation>пропустити </translation>
    </message>
    <message>
        <source>How many times the ray meets it before it stops</source>
        <translation>Скільки разів промінь її проходить, перш ніж зупинитися</translation>
    </message>
    <message numerus="yes">
        <source>On this ray: %n stop(s)</source>
        <translation>
            <numerusform>На цьому промені: %n зупинка</numerusform>
            <numerusform>На цьому промені: %n зупинки</numerusform>
            <numerusform>На цьому промені: %n зупинок</numerusform>
        </translation>
    </message>
    <message>
        <source>, the first %1 ignored</source>
        <translation>, перші %1 пропущено</translation>
    </message>
</context>
<context>
    <name>reliefui::ChartsView</name>
    <message>
        <source>Charts: other view</source>
        <translation>Діаграми: інший вигляд</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Діаграми</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>виміряти</translation>
    </message>
    <message>
        <source>live</source>
        <translation>наживо</translation>
    </message>
    <message>
        <source>with maps</source>
        <translation>із картами</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>середня похибка</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>найбільша похибка</translation>
    </message>
    <message>
        <source>all charts</source>
        <translation>усі діаграми</translation>
    </message>
    <message>
        <source>time and error</source>
        <translation>час і похибка</translation>
    </message>
    <message>
        <source>histograms</source>
        <translation>гістограми</translation>
    </message>
    <message>
        <source>cancel (%1%)</source>
        <translation>зупинити (%1&#xa0;%)</translation>
    </message>
    <message>
        <source>Choose method and its worst pixel</source>
        <translation>Вибрати метод і його найгірший піксель</translation>
    </message>
    <message numerus="yes">
        <source> · wrong outcome: %n rays</source>
        <translation>
            <numerusform> · інший результат пошуку: %n промінь</numerusform>
            <numerusform> · інший результат пошуку: %n промені</numerusform>
            <numerusform> · інший результат пошуку: %n променів</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exact: %n rays</source>
        <translation>
            <numerusform>точно: %n промінь</numerusform>
            <numerusform>точно: %n промені</numerusform>
            <numerusform>точно: %n променів</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>wrong outcome: %n rays</source>
        <translation>
            <numerusform>інший результат пошуку: %n промінь</numerusform>
            <numerusform>інший результат пошуку: %n промені</numerusform>
            <numerusform>інший результат пошуку: %n променів</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 steps: %n rays</source>
        <translation>
            <numerusform>кроків від %1 до %2: %n промінь</numerusform>
            <numerusform>кроків від %1 до %2: %n промені</numerusform>
            <numerusform>кроків від %1 до %2: %n променів</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 texels before the surface: %n rays</source>
        <translation>
            <numerusform>від %1 до %2 текселя перед поверхнею: %n промінь</numerusform>
            <numerusform>від %1 до %2 текселя перед поверхнею: %n промені</numerusform>
            <numerusform>від %1 до %2 текселя перед поверхнею: %n променів</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 texels behind it: %n rays</source>
        <translation>
            <numerusform>від %1 до %2 текселя за нею: %n промінь</numerusform>
            <numerusform>від %1 до %2 текселя за нею: %n промені</numerusform>
            <numerusform>від %1 до %2 текселя за нею: %n променів</numerusform>
        </translation>
    </message>
    <message>
        <source>Export the charts</source>
        <translation>Експортувати діаграми</translation>
    </message>
    <message>
        <source>Run time against error, steps and errors of all pixels</source>
        <translation>Час роботи та похибка методів; кроки й похибки всіх пікселів</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n rays</source>
        <translation>
            <numerusform>%1: %n промінь</numerusform>
            <numerusform>%1: %n промені</numerusform>
            <numerusform>%1: %n променів</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n крок</numerusform>
            <numerusform>%n кроки</numerusform>
            <numerusform>%n кроків</numerusform>
        </translation>
    </message>
    <message>
        <source>Measure run time and error of the methods on this view&apos;s rays, or cancel the measurement (Esc)</source>
        <translation>Виміряти час роботи й похибку методів на променях цього ракурсу або зупинити вимірювання (Esc)</translation>
    </message>
    <message>
        <source>Measure again automatically when the view changes</source>
        <translation>Вимірювати знову автоматично, коли змінюється ракурс</translation>
    </message>
    <message>
        <source>Also measure methods with distance and cone maps, which take time to build</source>
        <translation>Вимірювати також методи з картами відстаней і конусів, побудова яких потребує часу</translation>
    </message>
    <message>
        <source>Error on the vertical axis</source>
        <translation>Похибка на вертикальній осі</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95-й процентиль</translation>
    </message>
    <message>
        <source>99.99th percentile</source>
        <translation>99,99-й процентиль</translation>
    </message>
    <message>
        <source>Charts to show</source>
        <translation>Діаграми, які показано</translation>
    </message>
    <message>
        <source>%1: %2 ns per ray ± %3%, error %4 mean, %5 at most, %6 steps</source>
        <translation>%1: %2 нс на промінь ± %3&#xa0;%, похибка в середньому %4, найбільша %5, кроків %6</translation>
    </message>
    <message>
        <source>%1 · click to choose such a pixel</source>
        <translation>%1 · клацніть, щоб вибрати такий піксель</translation>
    </message>
</context>
<context>
    <name>reliefui::ComparePictures</name>
    <message>
        <source>Move the divider</source>
        <translation>Пересунути роздільник</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>піксель (%1, %2)</translation>
    </message>
    <message>
        <source>divider %1 of %2</source>
        <translation>роздільник %1 з %2</translation>
    </message>
    <message>
        <source>Compare: the pictures side by side</source>
        <translation>Порівняння: зображення поруч</translation>
    </message>
</context>
<context>
    <name>reliefui::CompareText</name>
    <message>
        <source>(%1, %2) λ %3</source>
        <translation>(%1, %2) λ %3</translation>
    </message>
    <message>
        <source>, steps: %1</source>
        <translation>, кроків: %1</translation>
    </message>
    <message>
        <source>does not support this surface</source>
        <translation>не працює з такою поверхнею</translation>
    </message>
</context>
<context>
    <name>reliefui::CompareView</name>
    <message>
        <source>options</source>
        <translation>параметри</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Порівняння</translation>
    </message>
    <message>
        <source>Export the comparison</source>
        <translation>Експортувати порівняння</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>поруч</translation>
    </message>
    <message>
        <source>swipe</source>
        <translation>шторка</translation>
    </message>
    <message>
        <source>flicker</source>
        <translation>мерехтіння</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>різниця</translation>
    </message>
    <message>
        <source>against</source>
        <translation>відносно</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>The whole pictures (R); Ctrl+wheel zooms, Ctrl+drag moves</source>
        <translation>Зображення цілком (R); Ctrl + коліщатко змінює масштаб, Ctrl + перетягування пересуває</translation>
    </message>
    <message>
        <source>Speed of flicker</source>
        <translation>Швидкість мерехтіння</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Різниця</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Еталон</translation>
    </message>
    <message>
        <source>Compare</source>
        <comment>tab</comment>
        <translation>Поруч</translation>
    </message>
    <message>
        <source>Compared: %1</source>
        <translation>Порівнюється: %1</translation>
    </message>
    <message>
        <source>The options of each</source>
        <translation>Параметри кожного</translation>
    </message>
    <message>
        <source>methods</source>
        <translation>методи</translation>
    </message>
    <message>
        <source>filters</source>
        <translation>фільтри</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>координати</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>висоти</translation>
    </message>
    <message>
        <source>Compare: %1</source>
        <translation>Порівняння: %1</translation>
    </message>
    <message>
        <source>Swap with A</source>
        <translation>Поміняти місцями з A</translation>
    </message>
    <message>
        <source>Add another one to the comparison</source>
        <translation>Додати до порівняння ще одне</translation>
    </message>
    <message>
        <source>Remove the last one</source>
        <translation>Прибрати останнє</translation>
    </message>
    <message>
        <source>Property in which the pictures differ</source>
        <translation>Властивість, якою відрізняються зображення</translation>
    </message>
    <message>
        <source>How the pictures are compared</source>
        <translation>Спосіб порівняння зображень</translation>
    </message>
    <message>
        <source>Difference of the colours to show</source>
        <translation>Різниця кольорів, яку показано</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> за секунду</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Зображень за секунду</translation>
    </message>
    <message>
        <source>Show one after the other; A, B, C, D show a single one</source>
        <translation>Показувати одне за одним; A, B, C, D показують лише одне</translation>
    </message>
    <message>
        <source>Reference for measuring the pictures</source>
        <translation>Еталон, відносно якого вимірюються зображення</translation>
    </message>
    <message>
        <source>Compare methods, filters, coordinates or heights</source>
        <translation>Порівняти методи, фільтри, координати або висоти</translation>
    </message>
    <message>
        <source>Kind of comparison</source>
        <translation>Предмет порівняння</translation>
    </message>
    <message>
        <source>Add to comparison</source>
        <translation>Додати до порівняння</translation>
    </message>
    <message>
        <source>Remove from comparison</source>
        <translation>Прибрати з порівняння</translation>
    </message>
    <message>
        <source>%1 is already A; %2 is added instead.</source>
        <translation>%1 — це вже A; натомість додано %2.</translation>
    </message>
    <message>
        <source>%1 is already A and has no option by which to compare it with itself.</source>
        <translation>%1 — це вже A, і в нього немає параметра, щоб порівняти його з самим собою.</translation>
    </message>
    <message>
        <source>Comparison mode</source>
        <translation>Спосіб порівняння</translation>
    </message>
    <message>
        <source>Make %1 the one (A) that all panes show</source>
        <translation>Зробити %1 варіантом A, який показують усі панелі</translation>
    </message>
</context>
<context>
    <name>reliefui::DistanceText</name>
    <message>
        <source>texels</source>
        <translation>текселів</translation>
    </message>
    <message>
        <source>lines at 1, 2 and 5 of each power of ten</source>
        <translation>лінії на 1, 2 і 5 кожного степеня десяти</translation>
    </message>
    <message>
        <source>lines at powers of ten</source>
        <translation>лінії на степенях десяти</translation>
    </message>
    <message>
        <source>height per texel</source>
        <translation>одиниць висоти на тексель</translation>
    </message>
</context>
<context>
    <name>reliefui::DistanceView</name>
    <message>
        <source>Distance map: other view</source>
        <translation>Карта відстаней: інший вигляд</translation>
    </message>
    <message>
        <source>Distance map</source>
        <translation>Карта відстаней</translation>
    </message>
    <message>
        <source>the method&apos;s map</source>
        <translation>карта методу</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>не віднімати</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>лінії</translation>
    </message>
    <message>
        <source>Lines of equal value</source>
        <translation>Лінії рівних значень</translation>
    </message>
    <message>
        <source>near the ray</source>
        <translation>біля променя</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>Slices at constant x, seen along the rows</source>
        <translation>Зрізи за сталого x, погляд уздовж рядків</translation>
    </message>
    <message>
        <source>Slices at constant y, seen along the columns</source>
        <translation>Зрізи за сталого y, погляд уздовж стовпців</translation>
    </message>
    <message>
        <source>Slices at constant height, seen from above</source>
        <translation>Зрізи за сталої висоти, погляд згори</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Зріз</translation>
    </message>
    <message>
        <source>at the step</source>
        <translation>на кроці</translation>
    </message>
    <message>
        <source>The slice goes through the current step of the ray</source>
        <translation>Зріз проходить через поточний крок променя</translation>
    </message>
    <message>
        <source>Progress of the map</source>
        <translation>Перебіг побудови карти</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Зупинити</translation>
    </message>
    <message>
        <source>Stop building the map (Esc)</source>
        <translation>Зупинити побудову карти (Esc)</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Побудувати</translation>
    </message>
    <message>
        <source>Build the map</source>
        <translation>Побудувати карту</translation>
    </message>
    <message>
        <source>beyond the edge</source>
        <translation>за краєм</translation>
    </message>
    <message>
        <source>height per texel</source>
        <translation>одиниць висоти на тексель</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>текселів</translation>
    </message>
    <message>
        <source>in the relief</source>
        <translation>у рельєфі</translation>
    </message>
    <message>
        <source>texel (%1, %2): </source>
        <translation>тексель (%1, %2): </translation>
    </message>
    <message>
        <source>voxel (%1, %2, %3): </source>
        <translation>воксель (%1, %2, %3): </translation>
    </message>
    <message>
        <source> · x %1, y %2</source>
        <translation> · x %1, y %2</translation>
    </message>
    <message>
        <source> · height %1</source>
        <translation> · висота %1</translation>
    </message>
    <message>
        <source> · step %1</source>
        <translation> · крок %1</translation>
    </message>
    <message>
        <source>Export the distance map</source>
        <translation>Експортувати карту відстаней</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 з %2</translation>
    </message>
    <message>
        <source>the ray&apos;s sector</source>
        <translation>сектор променя</translation>
    </message>
    <message>
        <source>sector %1</source>
        <translation>сектор %1</translation>
    </message>
    <message>
        <source>Distance map</source>
        <comment>tab</comment>
        <translation>Відстані</translation>
    </message>
    <message>
        <source>Map to show</source>
        <translation>Карта, яку показано</translation>
    </message>
    <message>
        <source>Map to subtract, which shows where the two differ</source>
        <translation>Карта, яку віднімають, щоб побачити, де ці дві відрізняються</translation>
    </message>
    <message>
        <source>Azimuth sector of the rays for which the values are valid</source>
        <translation>Азимутальний сектор променів, для яких справджуються ці значення</translation>
    </message>
    <message>
        <source>Show only the surroundings of the ray</source>
        <translation>Показувати лише околицю променя</translation>
    </message>
    <message>
        <source>Show all of the slice (R); wheel zooms, drag moves, click chooses a step, Ctrl+click shows the distances at a point</source>
        <translation>Показати весь зріз (R); коліщатко змінює масштаб, перетягування пересуває, клацання вибирає крок, клацання з Ctrl показує відстані в точці</translation>
    </message>
    <message>
        <source>Slice to show</source>
        <translation>Зріз, який показано</translation>
    </message>
    <message>
        <source>at the surface: the cell is tested</source>
        <translation>біля поверхні: комірку перевіряють</translation>
    </message>
    <message>
        <source>A slice through the map that the method uses</source>
        <translation>Зріз карти, яку використовує метод</translation>
    </message>
    <message>
        <source>Building the map was cancelled.</source>
        <translation>Карту не побудовано: побудову зупинено.</translation>
    </message>
</context>
<context>
    <name>reliefui::DoctorView</name>
    <message>
        <source>Doctor</source>
        <translation>Лікар</translation>
    </message>
    <message>
        <source>What is wrong with another tracer, from its rays and hits</source>
        <translation>Що не так з іншим методом — за його променями й перетинами</translation>
    </message>
    <message>
        <source>Export the diagnosis</source>
        <translation>Експорт діагнозу</translation>
    </message>
    <message>
        <source>diagnose</source>
        <translation>діагностувати</translation>
    </message>
    <message>
        <source>Read the files again and diagnose them, or cancel it (Esc)</source>
        <translation>Прочитати файли ще раз і діагностувати або зупинити (Esc)</translation>
    </message>
    <message>
        <source>Faults of the tracer; a click chooses the worst ray</source>
        <translation>Вади методу; клацання вибирає найгірший промінь</translation>
    </message>
    <message>
        <source>Choose a wrong ray</source>
        <translation>Вибір хибного променя</translation>
    </message>
    <message>
        <source>cancel (%1%)</source>
        <translation>зупинити (%1&#xa0;%)</translation>
    </message>
</context>
<context>
    <name>reliefui::DrawnGrid</name>
    <message>
        <source>Relief by hand: its texels</source>
        <translation>Рельєф вручну: його текселі</translation>
    </message>
    <message>
        <source>Drag a height</source>
        <translation>Змінити висоту мишею</translation>
    </message>
    <message>
        <source>column %1: height %2</source>
        <translation>стовпець %1: висота %2</translation>
    </message>
    <message>
        <source>texel (%1, %2): height %3</source>
        <translation>тексель (%1, %2): висота %3</translation>
    </message>
</context>
<context>
    <name>reliefui::DrawnView</name>
    <message>
        <source>By hand</source>
        <translation>Вручну</translation>
    </message>
    <message>
        <source>Export the relief by hand</source>
        <translation>Експортувати рельєф, накреслений вручну</translation>
    </message>
    <message>
        <source>start from…</source>
        <translation>почати з…</translation>
    </message>
    <message>
        <source>the picture, around the hit</source>
        <translation>зображення, навколо точки перетину</translation>
    </message>
    <message>
        <source>a plain</source>
        <translation>рівнини</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>профіль</translation>
    </message>
    <message>
        <source>height </source>
        <translation>висота </translation>
    </message>
    <message>
        <source>Start from the picture</source>
        <translation>Почати із зображення</translation>
    </message>
    <message>
        <source>Start from a plain</source>
        <translation>Почати з рівнини</translation>
    </message>
    <message>
        <source>Start from %1</source>
        <translation>Почати з: %1</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Профіль</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Сітка</translation>
    </message>
    <message>
        <source>Height of a texel</source>
        <translation>Висота текселя</translation>
    </message>
    <message>
        <source>A small relief, drawn texel by texel</source>
        <translation>Невеликий рельєф, накреслений тексель за текселем</translation>
    </message>
    <message>
        <source>Relief to start from; the colours of the picture are not used</source>
        <translation>Рельєф, з якого почати; кольори зображення не використовуються</translation>
    </message>
    <message>
        <source>Texels per side</source>
        <translation>Текселів на сторону</translation>
    </message>
    <message>
        <source>A single row, which all others repeat, drawn from the side</source>
        <translation>Один рядок, який повторюють усі інші, накреслений збоку</translation>
    </message>
    <message>
        <source>Height of the chosen texel, 0 to 1; type digits, press Enter or double-click the texel</source>
        <translation>Висота вибраного текселя, від 0 до 1; введіть цифри, натисніть Enter або двічі клацніть тексель</translation>
    </message>
</context>
<context>
    <name>reliefui::DuelModel</name>
    <message>
        <source>number of the step, decision, λ after it</source>
        <translation>номер кроку, рішення, λ після нього</translation>
    </message>
</context>
<context>
    <name>reliefui::DuelView</name>
    <message>
        <source>Duel</source>
        <translation>Двобій</translation>
    </message>
    <message>
        <source>What each method did</source>
        <translation>Що зробив кожен метод</translation>
    </message>
    <message>
        <source>Preparing: %1, %2 %</source>
        <translation>Підготовка: %1, %2&#xa0;%</translation>
    </message>
    <message>
        <source>%1  against</source>
        <translation>%1  проти</translation>
    </message>
    <message>
        <source>Methods of the duel</source>
        <translation>Методи двобою</translation>
    </message>
    <message>
        <source>%1: %2, step %3</source>
        <translation>%1: %2, крок %3</translation>
    </message>
    <message>
        <source>Export the duel</source>
        <translation>Експортувати двобій</translation>
    </message>
    <message>
        <source>near the ray</source>
        <translation>біля променя</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, крок %2</translation>
    </message>
    <message>
        <source>λ %1 · surface %2 · ray %3</source>
        <translation>λ %1 · поверхня %2 · промінь %3</translation>
    </message>
    <message>
        <source>Several methods on one ray, step by step</source>
        <translation>Кілька методів на одному промені, крок за кроком</translation>
    </message>
    <message>
        <source>divergence</source>
        <translation>розбіжність</translation>
    </message>
    <message>
        <source>Opponent number %1</source>
        <translation>Метод-суперник %1</translation>
    </message>
    <message>
        <source>Method to compete with; the compare pane uses the same methods</source>
        <translation>Метод-суперник; на панелі порівняння ті самі методи</translation>
    </message>
    <message>
        <source>All methods to their first step</source>
        <translation>Усі методи — на перший крок</translation>
    </message>
    <message>
        <source>One step back in lockstep</source>
        <translation>Синхронно на крок назад</translation>
    </message>
    <message>
        <source>One step forward in lockstep: the methods furthest behind take their next step</source>
        <translation>Синхронно на крок уперед: крок роблять методи, що відстали найбільше</translation>
    </message>
    <message>
        <source>All methods to their answers</source>
        <translation>Усі методи — до своїх відповідей</translation>
    </message>
    <message>
        <source>Go to the first step that contradicts the exact answer (Ctrl+D)</source>
        <translation>Перейти до першого кроку, який суперечить точній відповіді (Ctrl+D)</translation>
    </message>
    <message>
        <source>Show only the heights that the ray passes</source>
        <translation>Показувати лише висоти, через які проходить промінь</translation>
    </message>
    <message>
        <source>Steps of the methods in lockstep</source>
        <translation>Кроки методів синхронно</translation>
    </message>
    <message>
        <source>There is no duel, because it was cancelled or failed.</source>
        <translation>Двобою немає: його зупинено або він не вдався.</translation>
    </message>
    <message>
        <source>against %1, because no other method is chosen</source>
        <translation>відносно %1, бо іншого методу для порівняння немає</translation>
    </message>
</context>
<context>
    <name>reliefui::FigureView</name>
    <message>
        <source>Copy value</source>
        <translation>Копіювати значення</translation>
    </message>
    <message>
        <source>Distances at this point</source>
        <translation>Відстані в цій точці</translation>
    </message>
    <message>
        <source>Distances at a point</source>
        <translation>Відстані в точці</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Копіювати зображення</translation>
    </message>
    <message>
        <source>Export figure…</source>
        <translation>Експортувати рисунок…</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Рисунки</translation>
    </message>
    <message>
        <source>Width, pixels:</source>
        <translation>Ширина, пікселі:</translation>
    </message>
    <message>
        <source>Width, mm:</source>
        <translation>Ширина, мм:</translation>
    </message>
    <message>
        <source>Caption below the figure</source>
        <translation>Підпис під рисунком</translation>
    </message>
    <message>
        <source>Light on dark, as in the window</source>
        <translation>Світле на темному, як у вікні</translation>
    </message>
    <message>
        <source>This pane shows nothing yet that can be exported.</source>
        <translation>На цій панелі поки немає чого експортувати.</translation>
    </message>
    <message>
        <source>Width on paper; letters and lines have the same size at any width</source>
        <translation>Ширина на папері; літери й лінії мають той самий розмір за будь-якої ширини</translation>
    </message>
    <message>
        <source>Cancelled: %1 was not written.</source>
        <translation>Зупинено: %1 не записано.</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Прибрати точку</translation>
    </message>
    <message>
        <source>Another width</source>
        <translation>Інша ширина</translation>
    </message>
    <message>
        <source>Column of a journal (84 mm)</source>
        <translation>Колонка журналу (84 мм)</translation>
    </message>
    <message>
        <source>Page of a journal (174 mm)</source>
        <translation>Сторінка журналу (174 мм)</translation>
    </message>
    <message>
        <source>For:</source>
        <translation>Для:</translation>
    </message>
</context>
<context>
    <name>reliefui::FileDialogs</name>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 уже є. Замінити?</translation>
    </message>
</context>
<context>
    <name>reliefui::FilterBox</name>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;. %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;. %2</translation>
    </message>
</context>
<context>
    <name>reliefui::FootprintView</name>
    <message>
        <source>Footprint: neighbours</source>
        <translation>Проєкція пікселя: сусіди</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>Проєкція пікселя</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Сусіди</translation>
    </message>
    <message>
        <source>this pixel alone</source>
        <translation>лише цей піксель</translation>
    </message>
    <message>
        <source>and 4 neighbours</source>
        <translation>і 4 сусіди</translation>
    </message>
    <message>
        <source>and 8 neighbours</source>
        <translation>і 8 сусідів</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>Show all of the footprint (R); wheel zooms, drag moves</source>
        <translation>Показати всю проєкцію (R); коліщатко змінює масштаб, перетягування пересуває</translation>
    </message>
    <message>
        <source>level %1, texel (%2, %3)</source>
        <translation>рівень %1, тексель (%2, %3)</translation>
    </message>
    <message>
        <source>, partly hidden: weight %1 left out</source>
        <translation>, частково перекрито: ваговий коефіцієнт %1 не враховано</translation>
    </message>
    <message>
        <source> · ray: %1% of the pixel</source>
        <translation> · промінь: %1&#xa0;% пікселя</translation>
    </message>
    <message>
        <source>: hidden by the relief at (%1, %2), weight %3 left out</source>
        <translation>: перекрито рельєфом у (%1, %2), ваговий коефіцієнт %3 не враховано</translation>
    </message>
    <message>
        <source>: weight %1, %2%</source>
        <translation>: ваговий коефіцієнт %1, %2&#xa0;%</translation>
    </message>
    <message>
        <source> (%1, %2, %3)</source>
        <translation> (%1, %2, %3)</translation>
    </message>
    <message>
        <source> · seen</source>
        <translation> · видно</translation>
    </message>
    <message>
        <source> · r² %1</source>
        <translation> · r² %1</translation>
    </message>
    <message>
        <source>Export the footprint</source>
        <translation>Експортувати проєкцію пікселя</translation>
    </message>
    <message>
        <source>Footprint</source>
        <comment>tab</comment>
        <translation>Проєкція</translation>
    </message>
    <message>
        <source>The part of the texture that the pixel covers, and the weight of each texel</source>
        <translation>Проєкція пікселя на текстуру та ваговий коефіцієнт кожного текселя</translation>
    </message>
    <message>
        <source>Weight function and map of weights</source>
        <translation>Вагова функція і карта вагових коефіцієнтів</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>коефіцієнти</translation>
    </message>
    <message>
        <source>Footprint: weights</source>
        <translation>Проєкція пікселя: вагові коефіцієнти</translation>
    </message>
    <message>
        <source>Show the ellipses of neighbouring pixels and how they overlap</source>
        <translation>Показати еліпси сусідніх пікселів і їхнє накладання</translation>
    </message>
    <message>
        <source>Show the weight function and the weight map, if the pane has room for them</source>
        <translation>Показати вагову функцію і карту вагових коефіцієнтів, якщо на панелі вистачає місця</translation>
    </message>
    <message>
        <source>level %1, texel (%2, %3): is not counted</source>
        <translation>рівень %1, тексель (%2, %3): не враховується</translation>
    </message>
</context>
<context>
    <name>reliefui::FormulaView</name>
    <message>
        <source>Formulas</source>
        <translation>Формули</translation>
    </message>
    <message>
        <source>Export the formulas</source>
        <translation>Експортувати формули</translation>
    </message>
    <message>
        <source>The papers&apos; equations with the values of the chosen pixel and step</source>
        <translation>Рівняння зі статей зі значеннями вибраного пікселя та кроку</translation>
    </message>
</context>
<context>
    <name>reliefui::HomeView</name>
    <message>
        <source>First view</source>
        <translation>Початковий ракурс</translation>
    </message>
</context>
<context>
    <name>reliefui::LatestJob</name>
    <message>
        <source>not enough memory for this</source>
        <translation>на це бракує пам’яті</translation>
    </message>
</context>
<context>
    <name>reliefui::LayoutMenu</name>
    <message>
        <source>Save layout</source>
        <translation>Зберегти розташування</translation>
    </message>
    <message>
        <source>Name of the layout:</source>
        <translation>Назва розташування:</translation>
    </message>
    <message>
        <source>Layout %1</source>
        <translation>Розташування %1</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Ви&amp;далити</translation>
    </message>
</context>
<context>
    <name>reliefui::LessonMenu</name>
    <message>
        <source>Lesson</source>
        <translation>Урок</translation>
    </message>
    <message>
        <source>&amp;Open a folder of lessons…</source>
        <translation>&amp;Відкрити теку уроків…</translation>
    </message>
    <message>
        <source>A lesson, or a folder of lessons, of your own</source>
        <translation>Власний урок або тека уроків</translation>
    </message>
    <message>
        <source>&amp;Make a lesson of this…</source>
        <translation>&amp;Зробити з цього урок…</translation>
    </message>
    <message>
        <source>A new lesson whose first page is what the window shows now</source>
        <translation>Новий урок, перша сторінка якого – те, що вікно показує зараз</translation>
    </message>
    <message>
        <source>&amp;Write as a page for browsers…</source>
        <translation>Запи&amp;сати як сторінку для браузера…</translation>
    </message>
    <message>
        <source>The open lesson as one HTML file, which needs no program and no network</source>
        <translation>Відкритий урок як один файл HTML, якому не потрібні ні програма, ні мережа</translation>
    </message>
    <message>
        <source>Lecturer’s &amp;notes</source>
        <translation>&amp;Нотатки викладача</translation>
    </message>
    <message>
        <source>Notes on the page in a window of their own, for a second screen</source>
        <translation>Нотатки до сторінки в окремому вікні, для другого екрана</translation>
    </message>
    <message>
        <source>&amp;Lecture</source>
        <translation>&amp;Лекція</translation>
    </message>
    <message>
        <source>Page Down: answer, then next page; Page Up: back; 1 to 9: count a guess; B: black screen</source>
        <translation>Page Down: відповідь, потім наступна сторінка; Page Up: назад; 1–9: зарахувати припущення; B: чорний екран</translation>
    </message>
    <message>
        <source>Folder of lessons</source>
        <translation>Тека уроків</translation>
    </message>
    <message>
        <source>Folder of the new lesson</source>
        <translation>Тека нового уроку</translation>
    </message>
    <message>
        <source>my lesson</source>
        <translation>мій урок</translation>
    </message>
    <message>
        <source>The new lesson is in %1: write its texts there.</source>
        <translation>Новий урок – у теці %1: напишіть там його тексти.</translation>
    </message>
    <message>
        <source>No lesson is open</source>
        <translation>Жодного уроку не відкрито</translation>
    </message>
    <message>
        <source>Lecturer’s notes</source>
        <translation>Нотатки викладача</translation>
    </message>
</context>
<context>
    <name>reliefui::LessonPane</name>
    <message>
        <source>Text of the lesson</source>
        <translation>Текст уроку</translation>
    </message>
    <message>
        <source>Your number, then Enter</source>
        <translation>Ваше число, потім Enter</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>Ваше число</translation>
    </message>
    <message>
        <source>Knob of the lesson</source>
        <translation>Регулятор уроку</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Попередня сторінка</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Зміст</translation>
    </message>
    <message>
        <source>Contents of the course</source>
        <translation>Зміст курсу</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Наступна сторінка</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>No lesson is open. The menu “Lessons” has them.</source>
        <translation>Жодного уроку не відкрито. Їх містить меню «Уроки».</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>сторінка %1 з %2</translation>
    </message>
    <message>
        <source>Question.</source>
        <translation>Запитання.</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Підказка</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Відповідь</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Правильно.</translation>
    </message>
    <message>
        <source>Not so.</source>
        <translation>Ні.</translation>
    </message>
    <message>
        <source>It is %1.</source>
        <translation>Це %1.</translation>
    </message>
    <message>
        <source>The scene was changed, so that none of the answers is the only right one.</source>
        <translation>Сцену змінено, тому жодна відповідь не є єдиною правильною.</translation>
    </message>
    <message>
        <source>You changed the scene: the numbers are those of what you see.</source>
        <translation>Ви змінили сцену: числа відповідають тому, що ви бачите.</translation>
    </message>
    <message>
        <source>Back to the page’s scene</source>
        <translation>Повернутися до сцени сторінки</translation>
    </message>
    <message>
        <source>Remember.</source>
        <translation>Запам’ятайте.</translation>
    </message>
    <message>
        <source>Notes for the lecturer</source>
        <translation>Нотатки для викладача</translation>
    </message>
    <message>
        <source>The answer:</source>
        <translation>Відповідь:</translation>
    </message>
    <message>
        <source>The lesson takes %1 minutes.</source>
        <translation>Урок триває %1 хв.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Далі: %1</translation>
    </message>
</context>
<context>
    <name>reliefui::LessonPlayer</name>
    <message>
        <source>Lesson %1</source>
        <translation>Урок %1</translation>
    </message>
    <message>
        <source>Knob of the lesson</source>
        <translation>Регулятор уроку</translation>
    </message>
</context>
<context>
    <name>reliefui::Lessons</name>
    <message>
        <source>A search in vain: a hit is possible but not confirmed ([MIP18])</source>
        <translation>Марна перевірка: перетин на ділянці не підтверджується ([MIP18])</translation>
    </message>
    <message>
        <source>The maximum of a texel of a higher level lies above the ray, so the search goes down a level. There no texel lies above the ray: the hit is not confirmed, and the search comes up again. The keys “,” and “.” go from step to step.</source>
        <translation>Максимум текселя на вищому рівні більший за висоту променя, тому трасування переходить на нижчий рівень; там жоден тексель не вищий за промінь, перетин не підтверджується, і трасування повертається на вищий рівень. Переходьте між кроками клавішами «,» та «.».</translation>
    </message>
    <message>
        <source>Missed spike: layers against the maximum pyramid</source>
        <translation>Непомічений шпиль: шари проти MIP-піраміди максимальних значень</translation>
    </message>
    <message>
        <source>Not refined: the last layer is the answer</source>
        <translation>Не уточнено: відповідь — останній шар</translation>
    </message>
    <message>
        <source>The hit lies between two layers. The method of layers answers with the second of them; bisection narrows the interval down to the hit.</source>
        <translation>Точка перетину лежить між двома шарами. Метод шарів видає за відповідь другий із них, а ділення навпіл уточнює положення точки.</translation>
    </message>
    <message>
        <source>Interpolation leak: a secant over a drop in height</source>
        <translation>Хибний перетин через інтерполяцію: січна на перепаді висот</translation>
    </message>
    <message>
        <source>Between the last two layers the surface is replaced by a straight line; at a sharp drop in height the point that is found does not lie on the surface.</source>
        <translation>Між двома останніми шарами поверхню замінено прямою; на різкому перепаді висот знайдена точка не лежить на поверхні.</translation>
    </message>
    <message>
        <source>Stopped early: one step of parallax offset</source>
        <translation>Передчасна зупинка: зміщення за один крок (parallax mapping)</translation>
    </message>
    <message>
        <source>The offset is computed from one height; where the relief changes, the ray is still above the surface at the point that is found.</source>
        <translation>Зміщення обчислено за однією висотою; де рельєф змінюється, промінь у знайденій точці ще над поверхнею.</translation>
    </message>
    <message>
        <source>Unsafe map: relaxed cones</source>
        <translation>Ненадійна карта: розширені конуси</translation>
    </message>
    <message>
        <source>Grazing rays: more steps, and layers become visible ([DIST17])</source>
        <translation>Напрямок погляду, близький до дотичного: більше кроків, видно шаруватість ([DIST17])</translation>
    </message>
    <message>
        <source>Footprint: texels that the relief hides</source>
        <translation>Проєкція пікселя: текселі, перекриті рельєфом</translation>
    </message>
    <message>
        <source>Distance map: each step is as long as the stored distance</source>
        <translation>Карта відстаней: довжина кроку дорівнює збереженій відстані</translation>
    </message>
    <message>
        <source>Refined distance: 3 texels or 4</source>
        <translation>Уточнена відстань: 3 текселі чи 4</translation>
    </message>
    <message>
        <source>Unsafe map: interpolated distances</source>
        <translation>Ненадійна карта: інтерпольовані відстані</translation>
    </message>
    <message>
        <source>Distances are stored for the centres of voxels and interpolated between them; near a wall the interpolated distance is larger than the true one. The conservative map holds for the whole volume of a voxel.</source>
        <translation>Відстані збережено для центрів вокселів і між ними інтерпольовано; біля стінки інтерпольована відстань більша за справжню. Консервативна карта відстаней справджується для всього об’єму вокселя.</translation>
    </message>
    <message>
        <source>In a relaxed cone the ray may enter the relief once, so steps are longer. Behind a narrow ledge it has already left the relief again, and the hit is lost. A plain cone is always empty.</source>
        <translation>У розширеному конусі промінь може один раз зайти під поверхню, тому кроки довші; вузький виступ він може пройти наскрізь, і перетин утрачено. Звичайний конус завжди порожній.</translation>
    </message>
    <message>
        <source>At six degrees to the ground the ray meets neighbouring layers many texels apart. Compare the methods and their numbers of steps (choose “Steps” in the result).</source>
        <translation>За кута шість градусів до поверхні сусідні шари перетинають промінь у точках, віддалених на багато текселів. Порівняйте методи й перегляньте кількість кроків (вид зображення «Кроки»).</translation>
    </message>
    <message>
        <source>The ellipse, which is the projection of the pixel on the slanted relief, also covers texels that cannot be seen; the filter elliptical-visible finds them by back-tracing and leaves them out ([TEX]).</source>
        <translation>Еліпс — проєкція пікселя на похилий рельєф — охоплює і невидимі текселі; фільтр elliptical-visible зворотним трасуванням визначає їх і не враховує ([TEX]).</translation>
    </message>
    <message>
        <source>The slice shows the distance of each voxel from the surface. At every step the ray advances by that distance: it takes five steps to the floor, and four with the refined map of the next lesson. The last circle reaches below the floor, because distances are interpolated between the centres of voxels.</source>
        <translation>Зріз показує, як далеко від поверхні лежить кожен воксель. У кожній точці зупинки промінь просувається на цю відстань: п’ять кроків до дна, а з уточненою картою з наступного уроку — чотири. Останнє коло сягає нижче дна: між центрами вокселів відстані інтерпольовано.</translation>
    </message>
    <message>
        <source>Point C is 3 texels from the left wall. Rays from above that would meet that wall within 4 texels of C hit the right wall before they reach C. The nearest hit of all other rays is on the floor, 4 texels below; this is the refined distance. Ctrl+click shows the distances at another point.</source>
        <translation>Точка C лежить за 3 текселі від лівої стіни. Промені згори, які перетнули б цю стіну ближче ніж за 4 текселі від C, перетинають праву стіну ще до точки C; найближчий перетин усіх інших — на дні, на 4 текселі нижче: це уточнена відстань. Клацання з Ctrl показує відстані в іншій точці.</translation>
    </message>
    <message>
        <source>With sixteen layers the surface is sampled at only seventeen points of the ray, so a spike between two of them goes unnoticed. The maximum pyramid misses no hit.</source>
        <translation>За шістнадцяти шарів висоту поверхні перевіряють лише в сімнадцяти точках променя; шпиль між двома з них лишається непоміченим. MIP-піраміда максимальних значень не пропускає жодного перетину.</translation>
    </message>
</context>
<context>
    <name>reliefui::MainWindow</name>
    <message>
        <source>Start a&amp;new</source>
        <translation>Почати з&amp;аново</translation>
    </message>
    <message>
        <source>The pictures and the view of the first start</source>
        <translation>Зображення та ракурс першого запуску</translation>
    </message>
    <message>
        <source>Start anew</source>
        <translation>Почати заново</translation>
    </message>
    <message>
        <source>&amp;Longest pauses…</source>
        <translation>Найдовші па&amp;узи…</translation>
    </message>
    <message>
        <source>Longest pauses</source>
        <translation>Найдовші паузи</translation>
    </message>
    <message>
        <source>Layer of the result</source>
        <translation>Вид зображення</translation>
    </message>
    <message>
        <source>Reliefscope</source>
        <translation>Reliefscope</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Повідомлення</translation>
    </message>
    <message>
        <source>Height maps and scenarios</source>
        <translation>Карти висот і сценарії</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Усі файли</translation>
    </message>
    <message>
        <source>Open a height map or a scenario</source>
        <translation>Відкрити карту висот або сценарій</translation>
    </message>
    <message>
        <source>Open the colour picture of the relief</source>
        <translation>Відкрити кольорове зображення рельєфу</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Колір</translation>
    </message>
    <message>
        <source>Save scenario</source>
        <translation>Зберегти сценарій</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Сценарії</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Зберегти зображення</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Зображення</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: не вдалося записати: %2</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Збережено: %1</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>ще немає</translation>
    </message>
    <message>
        <source>Open these pictures, shipped with Reliefscope</source>
        <translation>Відкрити ці зображення, що йдуть разом із Reliefscope</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Відкрити: %1</translation>
    </message>
    <message>
        <source>One file at a time, please: a height map or a scenario</source>
        <translation>Будь ласка, по одному файлу: карта висот або сценарій</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Відкрити…</translation>
    </message>
    <message>
        <source>Open &amp;colour…</source>
        <translation>Відкрити &amp;колір…</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>&amp;Приклади</translation>
    </message>
    <message>
        <source>&amp;Recent files</source>
        <translation>&amp;Недавні файли</translation>
    </message>
    <message>
        <source>&amp;Save scenario…</source>
        <translation>&amp;Зберегти сценарій…</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>Зберегти з&amp;ображення…</translation>
    </message>
    <message>
        <source>Save the picture of the result</source>
        <translation>Зберегти зображення результату</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Ви&amp;йти</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Закрити вікно</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Редагування</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Скасувати</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Скасувати останню зміну</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторити</translation>
    </message>
    <message>
        <source>&amp;Copy as command</source>
        <translation>&amp;Копіювати як команду</translation>
    </message>
    <message>
        <source>Copy the relief trace command of the chosen pixel</source>
        <translation>Копіювати команду relief trace для вибраного пікселя</translation>
    </message>
    <message>
        <source>Copy &amp;picture</source>
        <translation>Копіювати &amp;зображення</translation>
    </message>
    <message>
        <source>Copy the picture of the result</source>
        <translation>Копіювати зображення результату</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>З&amp;упинити</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вигляд</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>П&amp;ерейти</translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation>&amp;Панелі</translation>
    </message>
    <message>
        <source>Reset &amp;layout</source>
        <translation>Початкове &amp;розташування</translation>
    </message>
    <message>
        <source>Show the &amp;whole picture</source>
        <translation>Показати &amp;все зображення</translation>
    </message>
    <message>
        <source>Ligh&amp;t theme</source>
        <translation>&amp;Світла тема</translation>
    </message>
    <message>
        <source>Dark on light instead of light on dark</source>
        <translation>Темне на світлому замість світлого на темному</translation>
    </message>
    <message>
        <source>Pro&amp;jector</source>
        <translation>Про&amp;єктор</translation>
    </message>
    <message>
        <source>Full screen, large text, thick lines</source>
        <translation>На весь екран, великий текст, товсті лінії</translation>
    </message>
    <message>
        <source>&amp;Ray</source>
        <translation>Про&amp;мінь</translation>
    </message>
    <message>
        <source>&amp;First step</source>
        <translation>&amp;Перший крок</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>Попередні&amp;й крок</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Наступний крок</translation>
    </message>
    <message>
        <source>&amp;Last step</source>
        <translation>&amp;Останній крок</translation>
    </message>
    <message>
        <source>Pla&amp;y</source>
        <translation>&amp;Відтворити</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Пробіл</translation>
    </message>
    <message>
        <source>&amp;Go to pixel…</source>
        <translation>До пікс&amp;еля…</translation>
    </message>
    <message>
        <source>Choose a pixel by its coordinates</source>
        <translation>Вибрати піксель за координатами</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Довідка</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Миша та клавіші</translation>
    </message>
    <message>
        <source>&amp;About Reliefscope</source>
        <translation>&amp;Про Reliefscope</translation>
    </message>
    <message>
        <source>%1 – Reliefscope</source>
        <translation>%1 — Reliefscope</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Скопійовано: %1</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Копіювати значення</translation>
    </message>
    <message>
        <source>Choose this pixel</source>
        <translation>Вибрати цей піксель</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Копіювати зображення</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Зберегти зображення…</translation>
    </message>
    <message>
        <source>Go to pixel</source>
        <translation>До пікселя</translation>
    </message>
    <message>
        <source>Column, row (0 to %1, 0 to %2):</source>
        <translation>Стовпець, рядок (від 0 до %1, від 0 до %2):</translation>
    </message>
    <message>
        <source>“%1” is not a pixel; write column, row</source>
        <translation>«%1» — не піксель; введіть стовпець, рядок</translation>
    </message>
    <message>
        <source>Click in the result</source>
        <translation>Клацання в результаті</translation>
    </message>
    <message>
        <source>choose the pixel</source>
        <translation>вибрати піксель</translation>
    </message>
    <message>
        <source>Drag in the result</source>
        <translation>Перетягування в результаті</translation>
    </message>
    <message>
        <source>turn the camera</source>
        <translation>повернути камеру</translation>
    </message>
    <message>
        <source>Wheel in the result</source>
        <translation>Коліщатко в результаті</translation>
    </message>
    <message>
        <source>change the camera&apos;s distance</source>
        <translation>змінити відстань камери</translation>
    </message>
    <message>
        <source>Ctrl + drag, Ctrl + wheel</source>
        <translation>Ctrl + перетягування, Ctrl + коліщатко</translation>
    </message>
    <message>
        <source>pan and zoom the picture</source>
        <translation>пересунути зображення, змінити його масштаб</translation>
    </message>
    <message>
        <source>the whole picture again</source>
        <translation>знову все зображення</translation>
    </message>
    <message>
        <source>Arrows in the result (with Shift: ten)</source>
        <translation>Стрілки в результаті (з Shift — по десять)</translation>
    </message>
    <message>
        <source>move the pixel</source>
        <translation>перемістити піксель</translation>
    </message>
    <message>
        <source>previous and next step</source>
        <translation>попередній і наступний крок</translation>
    </message>
    <message>
        <source>Home   End</source>
        <translation>Home   End</translation>
    </message>
    <message>
        <source>first and last step</source>
        <translation>перший і останній крок</translation>
    </message>
    <message>
        <source>go to a pane</source>
        <translation>перейти до панелі</translation>
    </message>
    <message>
        <source>Double click on a title</source>
        <translation>Подвійне клацання на заголовку</translation>
    </message>
    <message>
        <source>fill the window with the pane, and back</source>
        <translation>панель на все вікно й назад</translation>
    </message>
    <message>
        <source>undo and redo</source>
        <translation>скасувати й повторити</translation>
    </message>
    <message>
        <source>copy the relief trace command of the pixel</source>
        <translation>копіювати команду relief trace для пікселя</translation>
    </message>
    <message>
        <source>projector</source>
        <translation>проєктор</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Миша та клавіші</translation>
    </message>
    <message>
        <source>About Reliefscope</source>
        <translation>Про Reliefscope</translation>
    </message>
    <message>
        <source>Numbers are written with a decimal point: 12.5.</source>
        <translation>Дробові числа записано з десятковою крапкою: 12.5.</translation>
    </message>
    <message>
        <source>Reliefscope %1

Relief texturing on height maps, in a window that explains why a pixel looks as it does.</source>
        <translation>Reliefscope %1

Рельєфне текстурування за картами висот у вікні, яке пояснює, чому піксель має саме такий вигляд.</translation>
    </message>
    <message>
        <source>Save picture with its legend…</source>
        <translation>Зберегти зображення з легендою…</translation>
    </message>
    <message>
        <source>Open another &amp;tracer&apos;s steps…</source>
        <translation>Відкрити кроки іншого &amp;трасувальника…</translation>
    </message>
    <message>
        <source>Play the steps until a breakpoint</source>
        <translation>Відтворювати кроки до точки зупинки</translation>
    </message>
    <message>
        <source>Step &amp;over a level</source>
        <translation>Крок без з&amp;аходу на нижчі рівні</translation>
    </message>
    <message>
        <source>Step &amp;back over a level</source>
        <translation>Назад без за&amp;ходу на нижчі рівні</translation>
    </message>
    <message>
        <source>&amp;Run to the next breakpoint</source>
        <translation>До наступної &amp;точки зупинки</translation>
    </message>
    <message>
        <source>Run bac&amp;k to a breakpoint</source>
        <translation>Назад до точки &amp;зупинки</translation>
    </message>
    <message>
        <source>&amp;Stop at this texel</source>
        <translation>З&amp;упинятися на цьому текселі</translation>
    </message>
    <message>
        <source>G&amp;uess the hit</source>
        <translation>&amp;Де перетин?</translation>
    </message>
    <message>
        <source>Hide the answer; a click in the profile guesses where the ray hits</source>
        <translation>Приховати відповідь; клацніть у профілі там, де очікуєте перетин</translation>
    </message>
    <message>
        <source>play the steps, until a breakpoint</source>
        <translation>відтворювати кроки до точки зупинки</translation>
    </message>
    <message>
        <source>step over a level, and back</source>
        <translation>крок без заходу на нижчі рівні, вперед і назад</translation>
    </message>
    <message>
        <source>run to the next breakpoint, and back</source>
        <translation>до наступної точки зупинки й назад</translation>
    </message>
    <message>
        <source>set a breakpoint at this texel</source>
        <translation>точка зупинки на цьому текселі</translation>
    </message>
    <message>
        <source>next pixel: largest error, most steps, overshoot, disagreement</source>
        <translation>наступний піксель: найбільша похибка, найбільше кроків, проскок, розбіжність</translation>
    </message>
    <message>
        <source>add a bookmark, go to the next one</source>
        <translation>додати закладку, перейти до наступної</translation>
    </message>
    <message>
        <source>guess where the ray hits, by a click in the profile</source>
        <translation>позначити клацанням у профілі, де очікується перетин</translation>
    </message>
    <message>
        <source>Ctrl + click in the profile or the distance map</source>
        <translation>Ctrl + клацання у профілі чи карті відстаней</translation>
    </message>
    <message>
        <source>Next pixel &amp;worth seeing</source>
        <translation>Наступний вартий уваг&amp;и піксель</translation>
    </message>
    <message>
        <source>Largest &amp;error</source>
        <translation>Найбільша &amp;похибка</translation>
    </message>
    <message>
        <source>The pixel whose hit is farthest from the exact one; again: the next</source>
        <translation>Піксель, точка перетину якого найдалі від точної; ще раз — наступний</translation>
    </message>
    <message>
        <source>Most &amp;steps</source>
        <translation>Найбільше &amp;кроків</translation>
    </message>
    <message>
        <source>The pixel whose ray takes the most steps; again: the next</source>
        <translation>Піксель, промінь якого робить найбільше кроків; ще раз — наступний</translation>
    </message>
    <message>
        <source>&amp;Overshoot</source>
        <translation>Пр&amp;оскок</translation>
    </message>
    <message>
        <source>The pixel whose ray goes farthest past the surface; again: the next</source>
        <translation>Піксель, промінь якого заходить найдалі за поверхню; ще раз — наступний</translation>
    </message>
    <message>
        <source>&amp;Disagreement</source>
        <translation>&amp;Розбіжність</translation>
    </message>
    <message>
        <source>The pixel where the compared methods are farthest apart; again: the next</source>
        <translation>Піксель, де порівнювані методи розходяться найбільше; ще раз — наступний</translation>
    </message>
    <message>
        <source>Book&amp;marks</source>
        <translation>За&amp;кладки</translation>
    </message>
    <message>
        <source>&amp;Add bookmark</source>
        <translation>&amp;Додати закладку</translation>
    </message>
    <message>
        <source>Keep this pixel, the camera and the step</source>
        <translation>Запам’ятати цей піксель, камеру та крок</translation>
    </message>
    <message>
        <source>&amp;Next bookmark</source>
        <translation>&amp;Наступна закладка</translation>
    </message>
    <message>
        <source>Go to the next bookmark</source>
        <translation>Перейти до наступної закладки</translation>
    </message>
    <message>
        <source>Na&amp;mes…</source>
        <translation>Н&amp;азви…</translation>
    </message>
    <message>
        <source>Rays of another tracer: s0,t0,a,b in texels</source>
        <translation>Промені іншого трасувальника: s0,t0,a,b у текселях</translation>
    </message>
    <message>
        <source>Rays (*.csv);;All files (*)</source>
        <translation>Промені (*.csv);;Усі файли (*)</translation>
    </message>
    <message>
        <source>drawn by hand</source>
        <translation>накреслений вручну</translation>
    </message>
    <message>
        <source>first divergence of the duel</source>
        <translation>перша розбіжність двобою</translation>
    </message>
    <message>
        <source>First di&amp;vergence of the duel</source>
        <translation>Перша роз&amp;біжність двобою</translation>
    </message>
    <message>
        <source>Export figure…</source>
        <translation>Експортувати рисунок…</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>Експортувати рисунок</translation>
    </message>
    <message>
        <source>&amp;Export the pane…</source>
        <translation>&amp;Експортувати панель…</translation>
    </message>
    <message>
        <source>Play fas&amp;ter</source>
        <translation>Відтворювати &amp;швидше</translation>
    </message>
    <message>
        <source>Play slo&amp;wer</source>
        <translation>Відтворювати пов&amp;ільніше</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Уроки</translation>
    </message>
    <message>
        <source>Lesson: %1</source>
        <translation>Урок «%1»</translation>
    </message>
    <message>
        <source>play slower, faster</source>
        <translation>відтворювати повільніше, швидше</translation>
    </message>
    <message>
        <source>Arrows in the trace (with Shift: move), + −</source>
        <translation>Стрілки в трасуванні 3D (з Shift: пересунути), + −</translation>
    </message>
    <message>
        <source>turn the trace, zoom</source>
        <translation>повернути трасування 3D, змінити масштаб</translation>
    </message>
    <message>
        <source>Alt + arrows in the comparison</source>
        <translation>Alt + стрілки в порівнянні</translation>
    </message>
    <message>
        <source>move the divider, take the next one</source>
        <translation>пересунути роздільник, узяти наступний</translation>
    </message>
    <message>
        <source>export the pane as SVG, PDF or PNG</source>
        <translation>експортувати панель як SVG, PDF або PNG</translation>
    </message>
    <message>
        <source>Digits in the relief by hand</source>
        <translation>Цифри в рельєфі, накресленому вручну</translation>
    </message>
    <message>
        <source>type the height of the chosen texel</source>
        <translation>ввести висоту вибраного текселя</translation>
    </message>
    <message>
        <source>Tab, arrows</source>
        <translation>Tab, стрілки</translation>
    </message>
    <message>
        <source>T&amp;each</source>
        <translation>Виклада&amp;ння</translation>
    </message>
    <message>
        <source>Layo&amp;uts of your own</source>
        <translation>Власні розта&amp;шування</translation>
    </message>
    <message>
        <source>&amp;Save this layout…</source>
        <translation>&amp;Зберегти це розташування…</translation>
    </message>
    <message>
        <source>&amp;First view</source>
        <translation>П&amp;очатковий ракурс</translation>
    </message>
    <message>
        <source>The camera as it was when the scene was opened</source>
        <translation>Камера такою, якою була під час відкриття сцени</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>&amp;Мова</translation>
    </message>
    <message>
        <source>The language of the window</source>
        <translation>Мова вікна</translation>
    </message>
    <message>
        <source>Show rays from the&amp;ir end</source>
        <translation>Показувати промені з кін&amp;ця</translation>
    </message>
    <message>
        <source>teach: one pane large, the picture in a corner</source>
        <translation>викладання: одна велика панель, зображення в кутку</translation>
    </message>
    <message>
        <source>Welcome. Three things to do: click a pixel to choose its ray; step along it with , and . (comma, full stop); drag the picture to look around. F1 lists all keys.</source>
        <translation>Вітаємо. Три перші дії: клацніть піксель, щоб вибрати його промінь; крокуйте ним клавішами «,» та «.» (кома, крапка); тягніть зображення, щоб оглянути сцену. F1 показує всі клавіші.</translation>
    </message>
    <message>
        <source>Nothing to export: no pixel is chosen. Click one in the result.</source>
        <translation>Експортувати нема чого: піксель не вибрано. Клацніть піксель на зображенні.</translation>
    </message>
    <message>
        <source>Nothing to export: the chosen pixel shows no relief. Click on the relief.</source>
        <translation>Експортувати нема чого: вибраний піксель не показує рельєфу. Клацніть на рельєфі.</translation>
    </message>
    <message>
        <source>Nothing to export: the ray of the chosen pixel meets no relief. Click another pixel.</source>
        <translation>Експортувати нема чого: промінь вибраного пікселя не перетинає рельєфу. Клацніть інший піксель.</translation>
    </message>
    <message>
        <source>Man&amp;ual</source>
        <translation>Посі&amp;бник</translation>
    </message>
    <message>
        <source>The guide, the methods and the commands, in the browser</source>
        <translation>Посібник, методи й команди у браузері</translation>
    </message>
    <message>
        <source>Property of the pixels that the result shows</source>
        <translation>Властивість пікселів, яку показує результат</translation>
    </message>
    <message>
        <source>Nothing to export: there is only one picture. Press + in the compare pane.</source>
        <translation>Експортувати нема чого: зображення лише одне. Натисніть + на панелі порівняння.</translation>
    </message>
    <message>
        <source>The manual is not here: it is built by %1, before the programs are installed.</source>
        <translation>Посібника тут немає: його створює %1 перед встановленням програм.</translation>
    </message>
    <message>
        <source>The browser could not be started; the manual is %1</source>
        <translation>Браузер не вдалося запустити; посібник: %1</translation>
    </message>
    <message>
        <source>Save pictures, view and settings, to open them again</source>
        <translation>Зберегти зображення, ракурс і налаштування, щоб відкрити їх знову</translation>
    </message>
    <message>
        <source>Export the pane that has the keyboard focus as SVG, PDF or PNG</source>
        <translation>Експортувати панель, на якій фокус клавіатури, як SVG, PDF або PNG</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Повторити останню скасовану зміну</translation>
    </message>
    <message>
        <source>Show one pane large, the picture in a corner and the step in words</source>
        <translation>Показати одну панель великою, зображення в кутку, а крок словами</translation>
    </message>
    <message>
        <source>Restore the original layout of the panes</source>
        <translation>Відновити початкове розташування панелей</translation>
    </message>
    <message>
        <source>Save the layout of the panes under a name</source>
        <translation>Зберегти розташування панелей під назвою</translation>
    </message>
    <message>
        <source>Reset the zoom of the result (R in the result)</source>
        <translation>Скинути масштаб результату (R на результаті)</translation>
    </message>
    <message>
        <source>As in the system</source>
        <translation>Як у системі</translation>
    </message>
    <message>
        <source>Go to the first step of the ray</source>
        <translation>Перейти до першого кроку променя</translation>
    </message>
    <message>
        <source>Go one step back</source>
        <translation>На крок назад</translation>
    </message>
    <message>
        <source>Go one step forward</source>
        <translation>На крок уперед</translation>
    </message>
    <message>
        <source>Go to the last step of the ray</source>
        <translation>Перейти до останнього кроку променя</translation>
    </message>
    <message>
        <source>More steps per second</source>
        <translation>Більше кроків на секунду</translation>
    </message>
    <message>
        <source>Fewer steps per second</source>
        <translation>Менше кроків на секунду</translation>
    </message>
    <message>
        <source>Go forward, skipping steps on finer levels</source>
        <translation>Уперед, пропускаючи кроки на нижчих рівнях</translation>
    </message>
    <message>
        <source>Go back, skipping steps on finer levels</source>
        <translation>Назад, пропускаючи кроки на нижчих рівнях</translation>
    </message>
    <message>
        <source>Go to the next step that meets a breakpoint condition</source>
        <translation>Перейти до наступного кроку, на якому справджується умова точки зупинки</translation>
    </message>
    <message>
        <source>Go back to the previous breakpoint</source>
        <translation>Повернутися до попередньої точки зупинки</translation>
    </message>
    <message>
        <source>Set a breakpoint at the texel of the chosen step, or remove it</source>
        <translation>Поставити точку зупинки на текселі вибраного кроку або вилучити її</translation>
    </message>
    <message>
        <source>Show the last step of the ray instead of the first when a pixel is chosen</source>
        <translation>Після вибору пікселя показувати останній крок його променя, а не перший</translation>
    </message>
    <message>
        <source>List the mouse actions and keys</source>
        <translation>Перелік дій миші та клавіш</translation>
    </message>
    <message>
        <source>Work that blocked the window longest</source>
        <translation>Робота, яка найдовше затримувала вікно (назви — англійською)</translation>
    </message>
    <message>
        <source>About this program</source>
        <translation>Про цю програму</translation>
    </message>
    <message>
        <source>first view of the camera</source>
        <translation>початковий ракурс камери</translation>
    </message>
    <message>
        <source>show the distances at that point; again: remove the point</source>
        <translation>показати відстані в цій точці; ще раз: прибрати точку</translation>
    </message>
    <message>
        <source>go to a control and change it; Enter in a number field: back to the view</source>
        <translation>перейти до елемента керування та змінити його; Enter у полі числа: назад до зображення</translation>
    </message>
    <message>
        <source>Go to the first step that contradicts the exact answer</source>
        <translation>Перейти до першого кроку, який суперечить точній відповіді</translation>
    </message>
    <message>
        <source>Rename and remove bookmarks</source>
        <translation>Перейменувати чи вилучити закладки</translation>
    </message>
    <message>
        <source>Cancel the running work; without any, leave guessing, a filled pane or the projector</source>
        <translation>Зупинити поточну роботу; якщо її немає, завершити «Де перетин?», панель на все вікно чи режим проєктора</translation>
    </message>
    <message>
        <source>cancel the running work; without any, leave guessing, a filled pane or the projector</source>
        <translation>зупинити поточну роботу; якщо її немає, завершити «Де перетин?», панель на все вікно чи режим проєктора</translation>
    </message>
    <message>
        <source>S&amp;hare the pane as a page…</source>
        <translation>По&amp;ділитися панеллю як сторінкою…</translation>
    </message>
    <message>
        <source>The pane in use as one HTML file with a slider over the steps, for any browser</source>
        <translation>Поточна панель як один файл HTML з повзунком кроків, для будь-якого браузера</translation>
    </message>
    <message>
        <source>&amp;Short scenes</source>
        <translation>&amp;Короткі сцени</translation>
    </message>
    <message>
        <source>Open a file of rays and a file of the steps or hits of another tracer on them</source>
        <translation>Відкрити файл променів і файл кроків або перетинів іншого методу на них</translation>
    </message>
    <message>
        <source>&amp;Moving picture…</source>
        <translation>&amp;Рухоме зображення…</translation>
    </message>
    <message>
        <source>A pane at each step, from all sides, or while an option changes: as a page for browsers or as numbered pictures</source>
        <translation>Панель на кожному кроці, з усіх боків або під час зміни параметра: як сторінка для браузера або пронумеровані зображення</translation>
    </message>
    <message>
        <source>Run to the next &amp;change</source>
        <translation>До наступної з&amp;міни</translation>
    </message>
    <message>
        <source>Go to the next step at which the chosen value of the pane Watch changes</source>
        <translation>Перейти до наступного кроку, на якому змінюється вибрана величина панелі «Спостереження»</translation>
    </message>
    <message>
        <source>Run back to a c&amp;hange</source>
        <translation>До попе&amp;редньої зміни</translation>
    </message>
    <message>
        <source>Go back to the step before the watched value became what it is</source>
        <translation>Повернутися до кроку, після якого спостережувана величина стала такою, як тепер</translation>
    </message>
    <message>
        <source>run to the next change of the watched value, and back</source>
        <translation>до наступної зміни спостережуваної величини і назад</translation>
    </message>
    <message>
        <source>Its steps or hits on them</source>
        <translation>Його кроки або перетини на них</translation>
    </message>
    <message>
        <source>Steps or hits (*.csv *.json);;All files (*)</source>
        <translation>Кроки або перетини (*.csv *.json);;Усі файли (*)</translation>
    </message>
    <message>
        <source>add an annotation to the pane, choose the next one</source>
        <translation>додати позначку на панель, вибрати наступну</translation>
    </message>
</context>
<context>
    <name>reliefui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Повідомлення</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Закрити це повідомлення</translation>
    </message>
</context>
<context>
    <name>reliefui::MovingPicture</name>
    <message>
        <source>the steps of the ray</source>
        <translation>кроки променя</translation>
    </message>
    <message>
        <source>the camera, around its target</source>
        <translation>камера, навколо своєї цілі</translation>
    </message>
    <message>
        <source>Moving picture</source>
        <translation>Рухоме зображення</translation>
    </message>
    <message>
        <source>Pane:</source>
        <translation>Панель:</translation>
    </message>
    <message>
        <source>What changes:</source>
        <translation>Що змінюється:</translation>
    </message>
    <message>
        <source>FROM..TO, or values with commas between them</source>
        <translation>ВІД..ДО або значення через кому</translation>
    </message>
    <message>
        <source>Values:</source>
        <translation>Значення:</translation>
    </message>
    <message>
        <source>Frames:</source>
        <translation>Кадрів:</translation>
    </message>
    <message>
        <source>one page for browsers</source>
        <translation>одну сторінку для браузера</translation>
    </message>
    <message>
        <source>numbered pictures (PNG)</source>
        <translation>пронумеровані зображення (PNG)</translation>
    </message>
    <message>
        <source>Written as:</source>
        <translation>Записати як:</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Зображення (*.png)</translation>
    </message>
</context>
<context>
    <name>reliefui::NarrowBar</name>
    <message>
        <source>The controls further left</source>
        <translation>Елементи керування ліворуч</translation>
    </message>
    <message>
        <source>The controls further right</source>
        <translation>Елементи керування праворуч</translation>
    </message>
</context>
<context>
    <name>reliefui::NumberControl</name>
    <message>
        <source>%1 to %2 %3</source>
        <translation>від %1 до %2 %3</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, повзунок</translation>
    </message>
</context>
<context>
    <name>reliefui::OffscreenGl</name>
    <message>
        <source>this machine has no OpenGL that draws without a window</source>
        <translation>на цій машині OpenGL не малює без вікна</translation>
    </message>
</context>
<context>
    <name>reliefui::OptionsForm</name>
    <message>
        <source>This method has no options.</source>
        <translation>Цей метод не має параметрів.</translation>
    </message>
</context>
<context>
    <name>reliefui::OtherBar</name>
    <message>
        <source>ray </source>
        <translation>промінь </translation>
    </message>
    <message>
        <source>Ray of the file</source>
        <translation>Промінь із файлу</translation>
    </message>
    <message>
        <source>Close the other tracer&apos;s files</source>
        <translation>Закрити файли іншого трасувальника</translation>
    </message>
    <message>
        <source>Choose ray</source>
        <translation>Вибрати промінь</translation>
    </message>
    <message>
        <source>Open another tracer&apos;s steps</source>
        <translation>Відкрити кроки іншого трасувальника</translation>
    </message>
    <message>
        <source>Close another tracer&apos;s steps</source>
        <translation>Закрити кроки іншого трасувальника</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>із %1</translation>
    </message>
    <message>
        <source>steps of %1</source>
        <translation>кроки: %1</translation>
    </message>
    <message>
        <source>Ray of the file to show, numbered from 0</source>
        <translation>Промінь файлу, який показано, нумерація від 0</translation>
    </message>
    <message>
        <source>Tracer whose steps are shown</source>
        <translation>Трасувальник, чиї кроки показано</translation>
    </message>
    <message>
        <source>Tracer whose steps all panes show; the duel shows both</source>
        <translation>Трасувальник, чиї кроки показують усі панелі; двобій показує обидва</translation>
    </message>
</context>
<context>
    <name>reliefui::PaneTitle</name>
    <message>
        <source>Fill the window with this pane, and back (double click on the title)</source>
        <translation>Ця панель на все вікно й назад (подвійне клацання на заголовку)</translation>
    </message>
    <message>
        <source>Fill the window with %1</source>
        <translation>%1 на все вікно</translation>
    </message>
    <message>
        <source>%1: press %2 to go there, double-click to fill the window</source>
        <translation>%1: клавіша %2 — перейти сюди, подвійне клацання — на все вікно</translation>
    </message>
    <message>
        <source>Drag it to another place, or out of the window</source>
        <translation>Перетягніть на інше місце або за межі вікна</translation>
    </message>
    <message>
        <source>Close this pane; the menu View, Panes opens it again</source>
        <translation>Закрити цю панель; меню «Вигляд», «Панелі» відкриє її знову</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>Закрити «%1»</translation>
    </message>
</context>
<context>
    <name>reliefui::PauseLog</name>
    <message>
        <source>longest pause of the window: </source>
        <translation>найдовша пауза вікна: </translation>
    </message>
    <message>
        <source>%1 ms, of which %2 ms of painting: %3</source>
        <translation>%1 мс, з них %2 мс на малювання: %3</translation>
    </message>
</context>
<context>
    <name>reliefui::PictureView</name>
    <message>
        <source>Turn the camera</source>
        <translation>Повернути камеру</translation>
    </message>
    <message>
        <source>Move the camera</source>
        <translation>Пересунути камеру</translation>
    </message>
</context>
<context>
    <name>reliefui::PicturesBox</name>
    <message>
        <source>Pictures</source>
        <translation>Зображення</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Усі файли</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Висоти</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Колір</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Нормалі</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Відкрити…</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Відкрити: %1</translation>
    </message>
    <message>
        <source>Choose a picture file</source>
        <translation>Вибрати файл зображення</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Немає</translation>
    </message>
    <message>
        <source>No %1</source>
        <translation>Без: %1</translation>
    </message>
    <message>
        <source>Procedural relief</source>
        <translation>Процедурний рельєф</translation>
    </message>
    <message>
        <source>Make a procedural relief instead of reading a picture</source>
        <translation>Створити процедурний рельєф замість зображення</translation>
    </message>
    <message>
        <source>Procedural…</source>
        <translation>Процедурний…</translation>
    </message>
    <message>
        <source>Size of the procedural relief</source>
        <translation>Розмір процедурного рельєфу</translation>
    </message>
    <message>
        <source>Width in texels; the height keeps its ratio to it</source>
        <translation>Ширина в текселях; висота зберігає своє відношення до неї</translation>
    </message>
    <message>
        <source>Seed of the procedural relief</source>
        <translation>Зерно процедурного рельєфу</translation>
    </message>
    <message>
        <source>procedural relief</source>
        <translation>процедурний рельєф</translation>
    </message>
    <message>
        <source>none</source>
        <translation>немає</translation>
    </message>
    <message>
        <source>relief drawn by hand</source>
        <translation>рельєф, накреслений вручну</translation>
    </message>
    <message>
        <source>Use no picture here</source>
        <translation>Не використовувати зображення</translation>
    </message>
    <message>
        <source>Seed: each number gives another relief</source>
        <translation>Зерно: кожне число дає інший рельєф</translation>
    </message>
</context>
<context>
    <name>reliefui::PixelFinder</name>
    <message>
        <source>The picture is not complete yet</source>
        <translation>Зображення ще не готове</translation>
    </message>
    <message>
        <source>Every hit is the exact one</source>
        <translation>Усі перетини точні</translation>
    </message>
    <message>
        <source>No ray takes a step</source>
        <translation>Жоден промінь не робить кроків</translation>
    </message>
    <message>
        <source>No ray goes past the surface</source>
        <translation>Жоден промінь не заходить за поверхню</translation>
    </message>
    <message>
        <source>%1 of %2: pixel (%3, %4), %5</source>
        <translation>%1 із %2: піксель (%3, %4), %5</translation>
    </message>
    <message>
        <source>steps: %1</source>
        <translation>кроків: %1</translation>
    </message>
    <message>
        <source>another outcome</source>
        <translation>інший результат пошуку</translation>
    </message>
    <message>
        <source>%1 texels from %2</source>
        <translation>на %1 текс. від %2</translation>
    </message>
    <message>
        <source>%1 texels past the surface</source>
        <translation>на %1 текс. за поверхнею</translation>
    </message>
    <message>
        <source>%1 texels from the exact hit</source>
        <translation>за %1 текс. від точного перетину</translation>
    </message>
    <message>
        <source>%1 and %2 agree everywhere</source>
        <translation>%1 і %2 всюди дають те саме</translation>
    </message>
    <message>
        <source>Searching for pixels …</source>
        <translation>Пошук пікселів…</translation>
    </message>
    <message>
        <source>The search was cancelled</source>
        <translation>Пошук зупинено</translation>
    </message>
    <message>
        <source>outcome differs from that of %1</source>
        <translation>інший результат пошуку, ніж у %1</translation>
    </message>
</context>
<context>
    <name>reliefui::ProfileView</name>
    <message>
        <source>Profile: other view</source>
        <translation>Профіль: інший вигляд</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Профіль</translation>
    </message>
    <message>
        <source>all levels</source>
        <translation>усі рівні</translation>
    </message>
    <message>
        <source>near the ray</source>
        <translation>біля променя</translation>
    </message>
    <message>
        <source>true aspect</source>
        <translation>справжні пропорції</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>λ %1</source>
        <translation>λ %1</translation>
    </message>
    <message>
        <source>%1 texels, λ %2</source>
        <translation>%1 текселя, λ %2</translation>
    </message>
    <message>
        <source> · surface %1</source>
        <translation> · поверхня %1</translation>
    </message>
    <message>
        <source> · beyond the edge</source>
        <translation> · за краєм</translation>
    </message>
    <message>
        <source> · ray %1 · texel (%2, %3)</source>
        <translation> · промінь %1 · тексель (%2, %3)</translation>
    </message>
    <message>
        <source> · step %1</source>
        <translation> · крок %1</translation>
    </message>
    <message>
        <source>Export the profile</source>
        <translation>Експортувати профіль</translation>
    </message>
    <message>
        <source>guess</source>
        <translation>де перетин?</translation>
    </message>
    <message>
        <source>Section of the relief along the ray</source>
        <translation>Зріз рельєфу вздовж видового променя</translation>
    </message>
    <message>
        <source>Show the maxima of all levels, not only of those that the ray visited</source>
        <translation>Показати максимуми всіх рівнів, а не лише тих, на яких ішло трасування</translation>
    </message>
    <message>
        <source>Show only the heights that the ray passes</source>
        <translation>Показувати лише висоти, через які проходить промінь</translation>
    </message>
    <message>
        <source>Use one scale across and upwards, which shows the relief&apos;s true shape</source>
        <translation>Однаковий масштаб по горизонталі та вертикалі, який показує справжню форму рельєфу</translation>
    </message>
    <message>
        <source>Hide the answer until a click guesses where the ray hits (G)</source>
        <translation>Приховати відповідь, доки ви не клацнете там, де очікуєте перетин (G)</translation>
    </message>
    <message>
        <source>Show all of the ray (R); wheel zooms, drag moves, click chooses a step, Ctrl+click shows the distances at a point</source>
        <translation>Показати весь промінь (R); коліщатко змінює масштаб, перетягування пересуває, клацання вибирає крок, клацання з Ctrl показує відстані в точці</translation>
    </message>
</context>
<context>
    <name>reliefui::PyramidStack</name>
    <message>
        <source>Pyramid in 3-D</source>
        <translation>MIP-піраміда у 3D</translation>
    </message>
</context>
<context>
    <name>reliefui::PyramidView</name>
    <message>
        <source>Pyramid: other view</source>
        <translation>MIP-піраміда: інший вигляд</translation>
    </message>
    <message>
        <source>all</source>
        <translation>усі</translation>
    </message>
    <message>
        <source>3-D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>step %1 · voxel (%2, %3, %4)</source>
        <translation>крок %1 · воксель (%2, %3, %4)</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>MIP-піраміда</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <comment>tab</comment>
        <translation>MIP</translation>
    </message>
    <message>
        <source>max</source>
        <translation>макс.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>середнє</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>стежити</translation>
    </message>
    <message>
        <source>Zoom to the level of the current step</source>
        <translation>Показувати рівень поточного кроку</translation>
    </message>
    <message>
        <source>step %1 · %2</source>
        <translation>крок %1 · %2</translation>
    </message>
    <message>
        <source>near the ray</source>
        <translation>біля променя</translation>
    </message>
    <message>
        <source>Show only the surroundings of the ray, on every level</source>
        <translation>Показати лише околицю променя, на кожному рівні</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>Show all levels (R); wheel zooms, drag moves, click chooses a step</source>
        <translation>Показати всі рівні (R); коліщатко змінює масштаб, перетягування пересуває, клацання вибирає крок</translation>
    </message>
    <message>
        <source>level %1 (%2, %3): %4 · %5 texels</source>
        <translation>рівень %1 (%2, %3): %4 · %5 текселя</translation>
    </message>
    <message>
        <source>min</source>
        <translation>мін.</translation>
    </message>
    <message>
        <source>The lowest point under each texel</source>
        <translation>Найнижча точка під кожним текселем</translation>
    </message>
    <message>
        <source>Export the pyramid</source>
        <translation>Експортувати MIP-піраміду</translation>
    </message>
    <message>
        <source>The levels of the pyramid and the texels that the ray visited</source>
        <translation>Рівні MIP-піраміди й текселі, які перевірено під час трасування</translation>
    </message>
    <message>
        <source>The highest point under each texel, by which the ray skips texels</source>
        <translation>Найвища точка під кожним текселем: завдяки їй пропускаються порожні ділянки</translation>
    </message>
    <message>
        <source>The mean under each texel, with which colours are filtered</source>
        <translation>Середнє під кожним текселем: за ним фільтрують кольори</translation>
    </message>
    <message>
        <source>Show maxima, means and minima side by side</source>
        <translation>Показати максимуми, середні й мінімуми поруч</translation>
    </message>
    <message>
        <source>The levels one above another, with a slab for each texel, and the path of the ray</source>
        <translation>Рівні один над одним: кожен тексель — плита власного розміру; шлях променя між рівнями</translation>
    </message>
</context>
<context>
    <name>reliefui::RangeBox</name>
    <message>
        <source>linear</source>
        <translation>лінійно</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>логарифмічна шкала</translation>
    </message>
    <message>
        <source>all values</source>
        <translation>усі значення</translation>
    </message>
    <message>
        <source>percentiles</source>
        <translation>процентилі</translation>
    </message>
    <message>
        <source>Values up to it share one colour; the legend counts those above it</source>
        <translation>Значення до нього мають один колір; легенда рахує ті, що понад нього</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Поріг</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Стандартно</translation>
    </message>
    <message>
        <source>from</source>
        <translation>від</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>Range of the colours</source>
        <translation>Діапазон кольорів</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>обидва боки</translation>
    </message>
    <message>
        <source>Mapping of values to colours</source>
        <translation>Відображення значень у кольори</translation>
    </message>
    <message>
        <source>Ends of the colour range</source>
        <translation>Межі діапазону кольорів</translation>
    </message>
    <message>
        <source>custom ends</source>
        <translation>власні межі</translation>
    </message>
    <message>
        <source>Lower end of the colour range</source>
        <translation>Нижня межа діапазону кольорів</translation>
    </message>
    <message>
        <source>Upper end of the colour range</source>
        <translation>Верхня межа діапазону кольорів</translation>
    </message>
    <message>
        <source>only values above</source>
        <translation>лише значення понад</translation>
    </message>
    <message>
        <source>Reset to the default range of this picture</source>
        <translation>Повернути типовий діапазон цього зображення</translation>
    </message>
</context>
<context>
    <name>reliefui::RangeButton</name>
    <message>
        <source>Range of the colours</source>
        <translation>Діапазон кольорів</translation>
    </message>
    <message>
        <source>Range of the colours: linear, logarithmic, percentiles, custom ends, a threshold; a click on the colour bar also opens it</source>
        <translation>Діапазон кольорів: лінійний, логарифмічний, процентилі, власні межі, поріг; клацання на смузі кольорів також відкриває його</translation>
    </message>
</context>
<context>
    <name>reliefui::RangeText</name>
    <message numerus="yes">
        <source>%1 texels</source>
        <translation>
            <numerusform>%1 текс.</numerusform>
            <numerusform>%1 текс.</numerusform>
            <numerusform>%1 текс.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 voxels</source>
        <translation>
            <numerusform>%1 вокс.</numerusform>
            <numerusform>%1 вокс.</numerusform>
            <numerusform>%1 вокс.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 пікс.</numerusform>
            <numerusform>%1 пікс.</numerusform>
            <numerusform>%1 пікс.</numerusform>
        </translation>
    </message>
    <message>
        <source>percentiles %1 to %2</source>
        <translation>процентилі від %1 до %2</translation>
    </message>
    <message>
        <source>up to percentile %1</source>
        <translation>до процентиля %1</translation>
    </message>
    <message>
        <source>up to percentile %1 of absolute values</source>
        <translation>до процентиля %1 абсолютних значень</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>логарифмічна шкала</translation>
    </message>
    <message>
        <source>, logarithmic</source>
        <translation>, логарифмічна шкала</translation>
    </message>
    <message>
        <source>beyond: %1, up to ±%2</source>
        <translation>поза межами: %1, до ±%2</translation>
    </message>
    <message>
        <source>beyond: %1, up to %2</source>
        <translation>понад межу: %1, до %2</translation>
    </message>
    <message>
        <source>below: %1, down to %2</source>
        <translation>нижче межі: %1, до %2</translation>
    </message>
    <message>
        <source>more than %1: %2% (%3)</source>
        <translation>понад %1: %2 % (%3)</translation>
    </message>
    <message>
        <source>custom range</source>
        <translation>власні межі</translation>
    </message>
</context>
<context>
    <name>reliefui::RenderWorker</name>
    <message>
        <source>not enough memory for this</source>
        <translation>на це бракує пам’яті</translation>
    </message>
</context>
<context>
    <name>reliefui::RestoreOffer</name>
    <message>
        <source>Restore</source>
        <translation>Відновити</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Відкинути</translation>
    </message>
    <message>
        <source>Open that session again, with its bookmarks and panes; can be undone</source>
        <translation>Знову відкрити той сеанс із закладками й панелями; можна скасувати</translation>
    </message>
    <message>
        <source>Delete the saved session</source>
        <translation>Видалити збережений сеанс</translation>
    </message>
    <message>
        <source>The last start ended before its first picture was drawn. Its session was not opened again; it can be restored.</source>
        <translation>Минулий запуск завершився, перш ніж з’явилося перше зображення. Його сеанс не відкрито знову; сеанс можна відновити.</translation>
    </message>
    <message>
        <source>Reliefscope ended unexpectedly; the session can be restored as it was on %1.</source>
        <translation>Reliefscope завершився неочікувано; сеанс можна відновити таким, яким він був %1.</translation>
    </message>
</context>
<context>
    <name>reliefui::ResultText</name>
    <message numerus="yes">
        <source>%1: %n pixels</source>
        <translation>
            <numerusform>%1: %n піксель</numerusform>
            <numerusform>%1: %n пікселі</numerusform>
            <numerusform>%1: %n пікселів</numerusform>
        </translation>
    </message>
    <message>
        <source>steps of the ray</source>
        <translation>кроки променя</translation>
    </message>
    <message>
        <source>distance to the hit, texture widths</source>
        <translation>відстань до точки перетину, у ширинах текстури</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Колір</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Кроки</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Результат пошуку</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Глибина</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Нормалі</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>перетин</translation>
    </message>
    <message>
        <source>miss</source>
        <translation>без перетину</translation>
    </message>
    <message>
        <source>step limit</source>
        <translation>межа кроків</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>небо</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>піксель (%1, %2)</translation>
    </message>
    <message>
        <source>colour %1 (%2, %3, %4)</source>
        <translation>колір %1 (%2, %3, %4)</translation>
    </message>
    <message>
        <source>sky: no polygon here</source>
        <translation>небо: полігона тут немає</translation>
    </message>
    <message>
        <source>hit at texel (%1, %2), λ %3</source>
        <translation>точка перетину: тексель (%1, %2), λ %3</translation>
    </message>
    <message>
        <source>distance %1 texture widths</source>
        <translation>відстань %1 ширини текстури</translation>
    </message>
    <message>
        <source>steps: %1, reads: %2</source>
        <translation>кроків: %1, вибірок: %2</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>too early</source>
        <translation>зарано</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>проскок</translation>
    </message>
    <message>
        <source>wrong outcome</source>
        <translation>інший результат пошуку</translation>
    </message>
    <message>
        <source>u, texture widths, 0 to 1</source>
        <translation>u у частках ширини зображення, від 0 до 1</translation>
    </message>
    <message>
        <source>v, texture heights, 0 to 1</source>
        <translation>v у частках висоти зображення, від 0 до 1</translation>
    </message>
    <message>
        <source>a corner of the texture</source>
        <translation>кут текстури</translation>
    </message>
    <message>
        <source>x right, y up, z to the front</source>
        <translation>x праворуч, y вгору, z до глядача</translation>
    </message>
    <message>
        <source>normal in the scene&apos;s axes</source>
        <translation>нормаль в осях сцени</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Похибка</translation>
    </message>
    <message>
        <source>Texture place</source>
        <translation>Місце в текстурі</translation>
    </message>
    <message>
        <source>error: none</source>
        <translation>похибки немає</translation>
    </message>
    <message>
        <source>error %1 texels, %2</source>
        <translation>похибка %1 текселя, %2</translation>
    </message>
    <message>
        <source>normal (%1, %2, %3)</source>
        <translation>нормаль (%1, %2, %3)</translation>
    </message>
    <message>
        <source>u %1, v %2</source>
        <translation>u %1, v %2</translation>
    </message>
    <message>
        <source>footprint: major over minor axis</source>
        <translation>проєкція пікселя: відношення великої осі до малої</translation>
    </message>
    <message>
        <source>texels of the footprint hidden by the relief, %</source>
        <translation>текселі проєкції, перекриті рельєфом, %</translation>
    </message>
    <message>
        <source>Footprint anisotropy</source>
        <translation>Анізотропія проєкції</translation>
    </message>
    <message>
        <source>Hidden by the relief</source>
        <translation>Перекрите рельєфом</translation>
    </message>
    <message>
        <source>%1% of the footprint hidden</source>
        <translation>перекрито %1&#xa0;% проєкції</translation>
    </message>
    <message>
        <source>footprint: semi-axes %1 × %2 texels, ratio %3</source>
        <translation>проєкція пікселя: півосі %1 × %2 текселя, відношення %3</translation>
    </message>
    <message>
        <source>error against exact, texels: − too early, + overshoot</source>
        <translation>похибка відносно точного методу, у текселях: − зарано, + проскок</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>текселів</translation>
    </message>
    <message>
        <source>nothing to show: only the filter elliptical-visible determines what the relief hides</source>
        <translation>показувати нема чого: перекриття рельєфом перевіряє лише фільтр elliptical-visible</translation>
    </message>
</context>
<context>
    <name>reliefui::ResultView</name>
    <message>
        <source>Result: the rendered picture</source>
        <translation>Результат: сформоване зображення</translation>
    </message>
    <message>
        <source>Drawing the first picture…</source>
        <translation>Формується перше зображення…</translation>
    </message>
    <message>
        <source>No picture yet: open a height map, or drop one here.</source>
        <translation>Зображення ще немає: відкрийте карту висот або перетягніть її сюди.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>The picture or one of its layers; choose a pixel to see how it was computed</source>
        <translation>Зображення або один із його видів; виберіть піксель, щоб побачити, як його обчислено</translation>
    </message>
</context>
<context>
    <name>reliefui::RowsView</name>
    <message>
        <source>Rows: other variants</source>
        <translation>Рядки: інші варіанти</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Рядки</translation>
    </message>
    <message>
        <source>variants</source>
        <translation>варіанти</translation>
    </message>
    <message>
        <source>the picture&apos;s width</source>
        <translation>ширина зображення</translation>
    </message>
    <message numerus="yes">
        <source>%n pixels</source>
        <translation>
            <numerusform>%n піксель</numerusform>
            <numerusform>%n пікселі</numerusform>
            <numerusform>%n пікселів</numerusform>
        </translation>
    </message>
    <message>
        <source>log</source>
        <translation>лог.</translation>
    </message>
    <message>
        <source>Errors on a logarithmic scale</source>
        <translation>Похибки в логарифмічному масштабі</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>Show all of the row (R); wheel zooms, drag moves, click chooses a pixel</source>
        <translation>Показати весь рядок (R); коліщатко змінює масштаб, перетягування пересуває, клацання вибирає піксель</translation>
    </message>
    <message>
        <source>Variant %1</source>
        <translation>Варіант %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>немає</translation>
    </message>
    <message>
        <source>Streams of the row</source>
        <translation>Потоків у рядку</translation>
    </message>
    <message>
        <source>Pixels between two divisions</source>
        <translation>Пікселів між двома діленнями</translation>
    </message>
    <message>
        <source>error ≤ </source>
        <translation>похибка ≤ </translation>
    </message>
    <message>
        <source>anchor </source>
        <translation>перезапуск </translation>
    </message>
    <message>
        <source>anchor: auto</source>
        <translation>перезапуск: авто</translation>
    </message>
    <message>
        <source>pixel %1</source>
        <translation>піксель %1</translation>
    </message>
    <message>
        <source> · beyond the horizon</source>
        <translation> · за горизонтом</translation>
    </message>
    <message>
        <source>: u %1, v %2, error %3 texels</source>
        <translation>: u %1, v %2, похибка %3 текселя</translation>
    </message>
    <message>
        <source> · stream %1 of %2</source>
        <translation> · потік %1 із %2</translation>
    </message>
    <message>
        <source>Export the rows</source>
        <translation>Експортувати рядки</translation>
    </message>
    <message>
        <source>Texture coordinates along the pixel&apos;s row, computed in several ways</source>
        <translation>Текстурні координати вздовж рядка растеризації, обчислені кількома способами</translation>
    </message>
    <message>
        <source>Variants to compare, and their options</source>
        <translation>Варіанти для порівняння та їхні параметри</translation>
    </message>
    <message>
        <source>Width of the picture in pixels; on long rows rounding errors accumulate</source>
        <translation>Ширина зображення у пікселях; на довгих рядках похибки заокруглення накопичуються</translation>
    </message>
    <message>
        <source>Type of the numbers with which the variants compute</source>
        <translation>Тип чисел, якими обчислюють варіанти</translation>
    </message>
    <message>
        <source>given m</source>
        <translation>задане m</translation>
    </message>
    <message>
        <source>Largest error, texels, which determines the span</source>
        <translation>Найбільша похибка, у текселях: за нею визначається довжина відрізка</translation>
    </message>
    <message>
        <source>Pixels between exact restarts; 0: never; auto: chosen to keep an error of 1/256 texel</source>
        <translation>Пікселів між точними перезапусками; 0: ніколи; авто: щоб похибка не перевищувала 1/256 текселя</translation>
    </message>
    <message>
        <source> · restart here</source>
        <translation> · тут перезапуск із точного значення</translation>
    </message>
</context>
<context>
    <name>reliefui::ScenePanel</name>
    <message>
        <source>from the front</source>
        <translation>спереду</translation>
    </message>
    <message>
        <source>slanted</source>
        <translation>похило</translation>
    </message>
    <message>
        <source>grazing</source>
        <translation>під ковзним кутом</translation>
    </message>
    <message>
        <source>slanted, near</source>
        <translation>похило, зблизька</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ракурс</translation>
    </message>
    <message>
        <source>presets…</source>
        <translation>готові…</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>типові</translation>
    </message>
    <message>
        <source>Defaults of the method</source>
        <translation>Типові параметри методу</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Зображення</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Рельєф</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Камера</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Світло</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Picture drawn</source>
        <translation>Розмір зображення</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Поверхня</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Поза краєм</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Координати</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Сцена</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;. %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;. %2</translation>
    </message>
    <message>
        <source>no maps</source>
        <translation>без карт</translation>
    </message>
    <message>
        <source>maps %1 MiB</source>
        <translation>карти %1 МіБ</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Тіні</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>Pictures, method, filter, camera and light</source>
        <translation>Зображення, метод, фільтр, камера та світло</translation>
    </message>
    <message>
        <source>Surface between texels: a smooth patch, or one box per texel</source>
        <translation>Поверхня між текселями: гладка ділянка (білінійна інтерполяція) або стовпчик на тексель</translation>
    </message>
    <message>
        <source>Relief beyond the picture&apos;s rim: the picture again, the heights of its rim, or none</source>
        <translation>Рельєф за краєм зображення: знову зображення, висоти його краю або нічого</translation>
    </message>
    <message>
        <source>Surface that carries the relief</source>
        <translation>Поверхня, на яку накладено рельєф</translation>
    </message>
    <message>
        <source>Common views; drag in the picture for any other</source>
        <translation>Поширені ракурси; для будь-якого іншого перетягніть зображення</translation>
    </message>
    <message>
        <source>Set all options of the method to their defaults</source>
        <translation>Повернути всі параметри методу до типових значень</translation>
    </message>
    <message>
        <source>The relief casts shadows on itself</source>
        <translation>Рельєф кидає тіні сам на себе</translation>
    </message>
    <message>
        <source>Method for texture coordinates along a row of pixels: direct is exact; affine bends walls; subspan bends them between its divisions</source>
        <translation>Як обчислюються текстурні координати вздовж рядка растеризації: direct — точно; affine викривлює стіни, subspan викривлює їх між своїми діленнями</translation>
    </message>
    <message>
        <source>Guarantee of the method with these options, the surfaces that it supports, and the memory of its maps besides the heights</source>
        <translation>Гарантія методу з цими параметрами, поверхні, які він підтримує, і пам’ять його карт, окрім висот</translation>
    </message>
</context>
<context>
    <name>reliefui::ShaderView</name>
    <message>
        <source>Shader</source>
        <translation>Шейдер</translation>
    </message>
    <message>
        <source>The picture of the exported shader, compared with the CPU&apos;s</source>
        <translation>Зображення експортованого шейдера порівняно із зображенням CPU</translation>
    </message>
    <message>
        <source>Export the shader&apos;s picture</source>
        <translation>Експорт зображення шейдера</translation>
    </message>
    <message>
        <source>draw</source>
        <translation>намалювати</translation>
    </message>
    <message>
        <source>Draw the shader again and measure its time, or cancel it (Esc)</source>
        <translation>Виконати шейдер ще раз і виміряти його час або зупинити (Esc)</translation>
    </message>
    <message>
        <source>worst pixel</source>
        <translation>найгірший піксель</translation>
    </message>
    <message>
        <source>Choose the pixel with the largest difference</source>
        <translation>Вибрати піксель із найбільшою відмінністю</translation>
    </message>
    <message>
        <source>Difference to show, by which the worst pixel is found</source>
        <translation>Яку відмінність показати і за якою шукати найгірший піксель</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>кольори</translation>
    </message>
    <message>
        <source>hits</source>
        <translation>перетини</translation>
    </message>
    <message>
        <source>Shader: other difference</source>
        <translation>Шейдер: інша відмінність</translation>
    </message>
    <message>
        <source>cancel (%1%)</source>
        <translation>зупинити (%1&#xa0;%)</translation>
    </message>
</context>
<context>
    <name>reliefui::Share</name>
    <message>
        <source>Page for browsers</source>
        <translation>Сторінка для браузера</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Сторінки (*.html)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Cancelled: %1 was not written.</source>
        <translation>Скасовано: %1 не записано.</translation>
    </message>
</context>
<context>
    <name>reliefui::SkippedPanel</name>
    <message>
        <source>%1 of %2 (%3 %)</source>
        <translation>%1 з %2 (%3&#xa0;%)</translation>
    </message>
    <message>
        <source>measured: %1 texels in the mean, %2 at most</source>
        <translation>виміряно: похибка в середньому %1 текселя, найбільша %2</translation>
    </message>
    <message>
        <source>measured: %1 of linear light in the mean, %2 at most</source>
        <translation>виміряно: похибка кольору (лінійного) в середньому %1, найбільша %2</translation>
    </message>
    <message>
        <source>Not computed</source>
        <translation>Не обчислено</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Чому</translation>
    </message>
    <message>
        <source>Bounded by %1 texels</source>
        <translation>З обмеженою похибкою: до %1 текселя</translation>
    </message>
    <message>
        <source>Bounded: off</source>
        <translation>З обмеженою похибкою: вимкнено</translation>
    </message>
    <message>
        <source>Lossless: off</source>
        <translation>Без втрат: вимкнено</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Пропущене</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Кількість</translation>
    </message>
    <message>
        <source>Lossless: the picture does not change</source>
        <translation>Без втрат: зображення не змінюється</translation>
    </message>
    <message>
        <source>Work that was skipped for the picture, and why</source>
        <translation>Робота, яку для зображення пропущено, і чому</translation>
    </message>
    <message>
        <source>Work that the last frame skipped</source>
        <translation>Робота, яку пропустив останній кадр</translation>
    </message>
</context>
<context>
    <name>reliefui::SlabScene</name>
    <message>
        <source>level %1 · %2 × %2 texels</source>
        <translation>рівень %1 · плити %2 × %2 (у текселях)</translation>
    </message>
    <message>
        <source>level %1, drawn as level %2</source>
        <translation>рівень %1, показано як рівень %2</translation>
    </message>
    <message>
        <source>level %1, not drawn</source>
        <translation>рівень %1, не показано</translation>
    </message>
    <message>
        <source>levels %1 to %2, not drawn</source>
        <translation>рівні %1–%2, не показано</translation>
    </message>
    <message>
        <source>levels %1 texels apart</source>
        <translation>відстань між рівнями, у текселях: %1</translation>
    </message>
    <message>
        <source>heights × 1/%1</source>
        <translation>висоти × 1/%1</translation>
    </message>
    <message>
        <source>heights to scale</source>
        <translation>висоти в масштабі</translation>
    </message>
    <message>
        <source>maxima</source>
        <translation>максимуми</translation>
    </message>
    <message>
        <source>means</source>
        <translation>середні</translation>
    </message>
    <message>
        <source>minima</source>
        <translation>мінімуми</translation>
    </message>
</context>
<context>
    <name>reliefui::StateKeeper</name>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1: запис неможливий</translation>
    </message>
    <message>
        <source>Your work is not saved automatically: %1</source>
        <translation>Ваша робота не зберігається автоматично: %1</translation>
    </message>
</context>
<context>
    <name>reliefui::StatusLine</name>
    <message>
        <source>drawn by %1</source>
        <translation>сформовано: %1</translation>
    </message>
    <message>
        <source>Drawn by %1, which is faster and has the same hits; the time shown is that of %1. The steps shown are those of %2.
Click to switch the method to %1</source>
        <translation>Це зображення сформував метод %1: він швидший і дає ті самі перетини; час указано для нього. Кроки показано для методу %2.
Клацання: перейти до методу %1</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Stages of this frame (seconds of all threads together):</source>
        <translation>Етапи цього кадру (секунди всіх потоків процесора разом):</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>без змін, повторно використано</translation>
    </message>
    <message>
        <source>The chosen pixel</source>
        <translation>Вибраний піксель</translation>
    </message>
    <message>
        <source>The frame</source>
        <translation>Кадр</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Перебіг</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Зупинити</translation>
    </message>
    <message>
        <source>no pixel chosen</source>
        <translation>піксель не вибрано</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>піксель (%1, %2)</translation>
    </message>
    <message>
        <source>sky: no polygon here</source>
        <translation>небо: полігона тут немає</translation>
    </message>
    <message>
        <source>hit at texel (%1, %2), λ %3</source>
        <translation>точка перетину: тексель (%1, %2), λ %3</translation>
    </message>
    <message>
        <source>, the exact answer is a hit</source>
        <translation>, точна відповідь — перетин є</translation>
    </message>
    <message>
        <source>, there is no hit</source>
        <translation>, перетину немає</translation>
    </message>
    <message>
        <source>, %1 texels from the exact hit</source>
        <translation>, за %1 текс. від точного перетину</translation>
    </message>
    <message>
        <source>frame %1 ms</source>
        <translation>кадр %1 мс</translation>
    </message>
    <message>
        <source>frame %1 s</source>
        <translation>кадр %1 с</translation>
    </message>
    <message>
        <source> (%1 × %2)</source>
        <translation> (%1 × %2)</translation>
    </message>
    <message>
        <source>coordinates ±%1 texels</source>
        <translation>координати ±%1 текселя</translation>
    </message>
    <message>
        <source>Coordinates: %1, off by up to %2 texels</source>
        <translation>Координати: %1, похибка до %2 текселя</translation>
    </message>
    <message>
        <source>skipped: %1 %</source>
        <translation>пропущено: %1&#xa0;%</translation>
    </message>
    <message>
        <source>steps: %1, reads: %2</source>
        <translation>кроків: %1, вибірок: %2</translation>
    </message>
    <message>
        <source>ray %1 of the file</source>
        <translation>промінь %1 із файлу</translation>
    </message>
    <message>
        <source>figure: %1</source>
        <translation>рисунок: %1</translation>
    </message>
    <message>
        <source>Footprint ellipses: %1, semi-axes off by up to %2 %</source>
        <translation>Еліпси проєкцій: %1, півосі відхиляються щонайбільше на %2 %</translation>
    </message>
    <message>
        <source>footprint axes ±%1 %</source>
        <translation>осі проєкцій ±%1 %</translation>
    </message>
    <message>
        <source>Click to see what was skipped, and why</source>
        <translation>Клацніть, щоб побачити, що пропущено і чому</translation>
    </message>
    <message>
        <source>Cancel the running work (Esc)</source>
        <translation>Зупинити поточну роботу (Esc)</translation>
    </message>
    <message>
        <source>Cancel the running work</source>
        <translation>Зупинити поточну роботу</translation>
    </message>
    <message>
        <source>hidden until you guess</source>
        <translation>приховано до вашого припущення</translation>
    </message>
    <message>
        <source>building the map “%1”</source>
        <translation>побудова карти «%1»</translation>
    </message>
</context>
<context>
    <name>reliefui::StepBar</name>
    <message>
        <source>First step</source>
        <translation>Перший крок</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Попередній крок</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Наступний крок</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>Останній крок</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Відтворити</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Пробіл</translation>
    </message>
    <message>
        <source>Step of the ray</source>
        <translation>Крок променя</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>крок %1 з %2</translation>
    </message>
    <message>
        <source>no ray</source>
        <translation>немає променя</translation>
    </message>
    <message>
        <source>Play the steps</source>
        <translation>Відтворювати кроки</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Швидкість відтворення</translation>
    </message>
    <message>
        <source>Run to the next breakpoint</source>
        <translation>До наступної точки зупинки</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/с</translation>
    </message>
    <message>
        <source>Step over the steps on finer levels</source>
        <translation>Крок без заходу на нижчі рівні</translation>
    </message>
    <message>
        <source>Step of the ray; , and . go back and forward</source>
        <translation>Крок променя; клавіші «,» та «.» — назад і вперед</translation>
    </message>
    <message>
        <source>Steps per second while playing; ] faster, [ slower</source>
        <translation>Кроків на секунду під час відтворення; ] швидше, [ повільніше</translation>
    </message>
    <message>
        <source>hidden until you guess</source>
        <translation>приховано до вашого припущення</translation>
    </message>
    <message>
        <source>No value is watched: choose one in the pane Watch</source>
        <translation>Немає величини для спостереження: виберіть її на панелі «Спостереження»</translation>
    </message>
</context>
<context>
    <name>reliefui::StepModel</name>
    <message>
        <source>#</source>
        <translation>№</translation>
    </message>
    <message>
        <source>level</source>
        <translation>рівень</translation>
    </message>
    <message>
        <source>texel</source>
        <translation>тексель</translation>
    </message>
    <message>
        <source>λ in → out</source>
        <translation>λ вхід → вихід</translation>
    </message>
    <message>
        <source>ray height in → out</source>
        <translation>висота вхід → вихід</translation>
    </message>
    <message>
        <source>value</source>
        <translation>значення</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>рішення</translation>
    </message>
    <message>
        <source>λ after</source>
        <translation>λ після</translation>
    </message>
    <message>
        <source>number of the step</source>
        <translation>номер кроку</translation>
    </message>
    <message>
        <source>level of the pyramid, 0 the finest</source>
        <translation>рівень піраміди; 0 — базовий</translation>
    </message>
    <message>
        <source>texel of that level (cell of the surface on level 0)</source>
        <translation>тексель цього рівня (на рівні 0 — комірка поверхні)</translation>
    </message>
    <message>
        <source>descent of the ray, 0 the top of the slab, 1 its bottom</source>
        <translation>спуск променя; 0 — верх товщі рельєфу, 1 — її дно</translation>
    </message>
    <message>
        <source>height of the ray, 1 the top of the slab</source>
        <translation>висота променя; 1 — верх товщі рельєфу</translation>
    </message>
    <message>
        <source>the stored value that decided, here the maximum of the texel</source>
        <translation>значення, за яким прийнято рішення; тут — максимум текселя</translation>
    </message>
    <message>
        <source>decision of the tracer</source>
        <translation>рішення методу</translation>
    </message>
    <message>
        <source>where the ray continued</source>
        <translation>місце, звідки продовжено промінь</translation>
    </message>
    <message>
        <source>column of the other program&apos;s file</source>
        <translation>стовпець файлу іншої програми</translation>
    </message>
</context>
<context>
    <name>reliefui::StepSentence</name>
    <message>
        <source>The chosen step in words</source>
        <translation>Вибраний крок словами</translation>
    </message>
    <message>
        <source>This method logged no step.</source>
        <translation>Цей метод не записав жодного кроку.</translation>
    </message>
    <message>
        <source>No polygon covers the chosen pixel: click on the relief.</source>
        <translation>Вибраного пікселя не накриває жоден полігон: клацніть на рельєфі.</translation>
    </message>
    <message>
        <source>The steps of the chosen pixel&apos;s ray will appear here.</source>
        <translation>Тут з’являться кроки променя вибраного пікселя.</translation>
    </message>
</context>
<context>
    <name>reliefui::StepTable</name>
    <message>
        <source>Steps</source>
        <translation>Кроки</translation>
    </message>
    <message>
        <source>Table of steps</source>
        <translation>Таблиця кроків</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>Копіювати рядки</translation>
    </message>
    <message>
        <source>Export steps as CSV...</source>
        <translation>Експортувати кроки як CSV…</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Експортувати кроки</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Таблиці (*.csv)</translation>
    </message>
    <message>
        <source>The steps of the ray, one by one, and what each of them means</source>
        <translation>Кроки променя один за одним і що кожен із них означає</translation>
    </message>
</context>
<context>
    <name>reliefui::TopBar</name>
    <message>
        <source>Main bar</source>
        <translation>Головна панель</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>How the ray searches for the relief</source>
        <translation>Яким методом шукають перетин видового променя з рельєфом</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>no search</source>
        <translation>без пошуку</translation>
    </message>
    <message>
        <source>How the colour is sampled at the hit</source>
        <translation>Спосіб вибірки кольору в точці перетину</translation>
    </message>
</context>
<context>
    <name>reliefui::Trace3dView</name>
    <message>
        <source>Trace 3-D: other view</source>
        <translation>Трасування 3D: інший вигляд</translation>
    </message>
    <message>
        <source>Trace in 3-D</source>
        <translation>Трасування 3D</translation>
    </message>
    <message>
        <source>Keep the current step in the middle</source>
        <translation>Тримати поточний крок посередині</translation>
    </message>
    <message>
        <source>steps by decision</source>
        <translation>кроки за рішенням</translation>
    </message>
    <message>
        <source>steps by level</source>
        <translation>кроки за рівнем</translation>
    </message>
    <message>
        <source>steps by phase</source>
        <translation>кроки за фазою</translation>
    </message>
    <message>
        <source>heights × %1</source>
        <translation>висоти × %1</translation>
    </message>
    <message>
        <source>Exaggeration of heights</source>
        <translation>Перебільшення висот</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>усе</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>стежити</translation>
    </message>
    <message>
        <source>height 1</source>
        <translation>висота 1</translation>
    </message>
    <message>
        <source>%1: level %2, %3</source>
        <translation>%1: рівень %2, %3</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 texels</source>
        <translation>%1 × %2 × %3 текселів</translation>
    </message>
    <message>
        <source>%1: surface at %2</source>
        <translation>%1: поверхня на %2</translation>
    </message>
    <message>
        <source>%1: cone of slope %2</source>
        <translation>%1: конус із нахилом %2</translation>
    </message>
    <message>
        <source>Export the trace</source>
        <translation>Експортувати трасування 3D</translation>
    </message>
    <message>
        <source>Show the whole patch (R); drag or arrows turn, right drag or Shift+arrows move, wheel or + − zoom</source>
        <translation>Показати всю ділянку (R); перетягування або стрілки повертають, перетягування правою кнопкою або Shift зі стрілками пересувають, коліщатко або + − змінює масштаб</translation>
    </message>
    <message>
        <source>Trace 3-D</source>
        <translation>Трасування 3D</translation>
    </message>
    <message>
        <source>Trace 3-D</source>
        <comment>tab</comment>
        <translation>3D</translation>
    </message>
    <message>
        <source>The ray through the relief, in space</source>
        <translation>Видовий промінь крізь рельєф у просторі</translation>
    </message>
    <message>
        <source>%1: %2 texels of free space</source>
        <translation>%1: за картою вільно на %2 текселя</translation>
    </message>
    <message>
        <source>Meaning of the steps&apos; colours</source>
        <translation>Значення кольорів кроків</translation>
    </message>
    <message>
        <source>%1: refined distance %2 texels</source>
        <translation>%1: уточнена відстань, текселів: %2</translation>
    </message>
    <message>
        <source>Relief: %1 × %2 texels around the ray</source>
        <translation>Рельєф: %1 × %2 текселів навколо променя</translation>
    </message>
    <message>
        <source>%1; one height in %2 along each side</source>
        <translation>%1; одна висота з %2 вздовж кожної сторони</translation>
    </message>
</context>
<context>
    <name>reliefui::WatchView</name>
    <message>
        <source>Watch</source>
        <translation>Спостереження</translation>
    </message>
    <message>
        <source>Values of the steps as graphs, with the current step; runs to the next change of one</source>
        <translation>Величини кроків як графіки з поточним кроком; перехід до наступної зміни однієї з них</translation>
    </message>
    <message>
        <source>Export the watched values</source>
        <translation>Експорт спостережуваних величин</translation>
    </message>
    <message>
        <source>Value to watch</source>
        <translation>Величина для спостереження</translation>
    </message>
    <message>
        <source>Column of the steps, or an expression over them such as z_out - value; Enter adds it</source>
        <translation>Стовпець кроків або вираз над ними, наприклад z_out - value; Enter додає його</translation>
    </message>
    <message>
        <source>Watch this value</source>
        <translation>Спостерігати за цією величиною</translation>
    </message>
    <message>
        <source>Stop watching the chosen value</source>
        <translation>Не спостерігати за вибраною величиною</translation>
    </message>
    <message>
        <source>Watch: other values</source>
        <translation>Спостереження: інші величини</translation>
    </message>
    <message>
        <source>step %1 · %2 = %3</source>
        <translation>крок %1 · %2 = %3</translation>
    </message>
</context>
<context>
    <name>reliefui::WhyView</name>
    <message>
        <source>Why this colour</source>
        <translation>Чому такий колір</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Чому</translation>
    </message>
    <message>
        <source>Coverage, ray, hit, filter and light of the pixel, with numbers that multiply out to it</source>
        <translation>Покриття, промінь, перетин, фільтр і освітлення пікселя, з числами, добуток яких дає його колір</translation>
    </message>
    <message>
        <source>Export the pixel&apos;s history</source>
        <translation>Експорт історії пікселя</translation>
    </message>
</context>
<context>
    <name>reliefui::Workspace</name>
    <message>
        <source>Start</source>
        <translation>Початок</translation>
    </message>
    <message>
        <source>Choose pixel</source>
        <translation>Вибрати піксель</translation>
    </message>
    <message>
        <source>Choose step</source>
        <translation>Вибрати крок</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Відкрити: %1</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Перейти до: %1</translation>
    </message>
</context>
</TS>
