<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk_UA">
<context>
    <name>core</name>
    <message>
        <source>side of a voxel&apos;s footprint</source>
        <translation>сторона основи вокселя</translation>
    </message>
    <message>
        <source>Relief depth</source>
        <translation>Глибина рельєфу</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Кут піднесення</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Азимут</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Відстань</translation>
    </message>
    <message>
        <source>Fov</source>
        <translation>Кут огляду</translation>
    </message>
    <message>
        <source>Light azimuth</source>
        <translation>Азимут світла</translation>
    </message>
    <message>
        <source>Light elevation</source>
        <translation>Піднесення світла</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Фонове світло</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Інтенсивність</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висота</translation>
    </message>
    <message>
        <source>thickness of the relief slab</source>
        <translation>товщина рельєфу</translation>
    </message>
    <message>
        <source>vertical field of view</source>
        <translation>вертикальний кут огляду</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>градусів</translation>
    </message>
    <message>
        <source>texture widths</source>
        <translation>ширин текстури</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>текселів</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>пікселів</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точний</translation>
    </message>
    <message>
        <source>conservative</source>
        <translation>консервативний</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>наближений</translation>
    </message>
    <message>
        <source>the texel that holds the point</source>
        <translation>тексель, у якому лежить точка</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>формування вибірок</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>чотирикутників</translation>
    </message>
    <message>
        <source>Bilinear</source>
        <translation>Білінійна</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Стовпчики</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Повторення</translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation>Край</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Нічого</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Підлога</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Стіна</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Куб</translation>
    </message>
    <message>
        <source>brick wall in a running bond with deep mortar</source>
        <translation>цегляна стіна з ложковою перев’язкою і глибокими швами</translation>
    </message>
    <message>
        <source>thin needles on a low ground</source>
        <translation>тонкі голки на низькому тлі</translation>
    </message>
    <message>
        <source>square pits in a high plateau</source>
        <translation>квадратні ями у високому плато</translation>
    </message>
    <message>
        <source>thin columns on a low ground</source>
        <translation>тонкі стовпи на низькому тлі</translation>
    </message>
    <message>
        <source>blocks with buildings of different heights</source>
        <translation>квартали з будинками різної висоти</translation>
    </message>
    <message>
        <source>rough terrain: value noise in octaves</source>
        <translation>нерівна місцевість: шум, складений з октав</translation>
    </message>
    <message>
        <source>smooth hills: a few sines</source>
        <translation>гладкі пагорби: кілька синусоїд</translation>
    </message>
    <message>
        <source>eight terraces with vertical walls</source>
        <translation>вісім терас із вертикальними стінами</translation>
    </message>
    <message>
        <source>blocks of 0 and 1</source>
        <translation>блоки з 0 та 1</translation>
    </message>
    <message>
        <source>the 8 x 8 example of the max pyramid&apos;s paper</source>
        <translation>приклад 8 × 8 зі статті про MIP-піраміду максимальних значень ([MIP18])</translation>
    </message>
    <message>
        <source>two walls with a trench between them: the example of the refined map&apos;s paper</source>
        <translation>дві стіни й рів між ними: приклад зі статті про уточнену карту відстаней ([DIST17])</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>кадр</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>MIP-піраміда</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Густота</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Шари</translation>
    </message>
    <message>
        <source>Bisections</source>
        <translation>Поділи навпіл</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Рівень</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>Внутрішній метод</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Базовий MIP-рівень</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>шарів</translation>
    </message>
    <message>
        <source>layers</source>
        <comment>title</comment>
        <translation>шари</translation>
    </message>
    <message>
        <source>halvings</source>
        <translation>поділів</translation>
    </message>
    <message>
        <source>level</source>
        <translation>рівня</translation>
    </message>
    <message>
        <source>error against exact</source>
        <translation>похибка відносно точного методу</translation>
    </message>
    <message>
        <source>map euclidean</source>
        <translation>карта відстаней: euclidean</translation>
    </message>
    <message>
        <source>map euclidean-conservative</source>
        <translation>карта відстаней: euclidean-conservative</translation>
    </message>
    <message>
        <source>map refined-sampled</source>
        <translation>карта відстаней: refined-sampled</translation>
    </message>
    <message>
        <source>map refined</source>
        <translation>карта відстаней: refined</translation>
    </message>
    <message>
        <source>map cone</source>
        <translation>карта конусів: cone</translation>
    </message>
    <message>
        <source>map cone-dummer</source>
        <translation>карта конусів: cone-dummer</translation>
    </message>
    <message>
        <source>map relaxed-cone</source>
        <translation>карта конусів: relaxed-cone</translation>
    </message>
    <message>
        <source>samples along each side of a pixel</source>
        <translation>вибірок уздовж кожної сторони пікселя</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Вагова функція</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Сигма</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Радіус</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Рівні</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Анізотропія</translation>
    </message>
    <message>
        <source>Texel size</source>
        <translation>Розмір текселя</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Джерело коефіцієнтів</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Роздільна здатність</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Еліпс</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Форма</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Вибірки</translation>
    </message>
    <message>
        <source>Pixel model</source>
        <translation>Модель пікселя</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>комірок</translation>
    </message>
    <message>
        <source>Floor</source>
        <comment>option</comment>
        <translation>Найменша вісь</translation>
    </message>
    <message>
        <source>Bounded</source>
        <translation>Межа похибки</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Точність зберігання</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Ітерації</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Напрямки</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Сектори</translation>
    </message>
    <message>
        <source>Horizons</source>
        <translation>Сектори горизонту</translation>
    </message>
    <message>
        <source>Flattest</source>
        <translation>Найпологіший промінь</translation>
    </message>
    <message>
        <source>Footprint</source>
        <comment>option</comment>
        <translation>Основа вокселя</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Правило кроку</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Кінець трасування</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Поріг відстані</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Відстань до</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Карта відстаней</translation>
    </message>
    <message>
        <source>Implementation</source>
        <translation>Обчислення</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>rays</source>
        <translation>променів</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>кроків</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>азимутів</translation>
    </message>
    <message>
        <source>sectors</source>
        <translation>секторів</translation>
    </message>
    <message>
        <source>map packed-cones</source>
        <translation>карта конусів: packed</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Компонування карти</translation>
    </message>
    <message>
        <source>bump mapping</source>
        <translation>нахили висот (bump mapping)</translation>
    </message>
    <message>
        <source>cone steps, conservative</source>
        <translation>конуси, консервативні</translation>
    </message>
    <message>
        <source>cone steps, as published</source>
        <translation>конуси, як опубліковано</translation>
    </message>
    <message>
        <source>displacement mapping</source>
        <translation>зміщення вершин (displacement mapping)</translation>
    </message>
    <message>
        <source>distance map</source>
        <translation>карта відстаней</translation>
    </message>
    <message>
        <source>distance map, conservative</source>
        <translation>карта відстаней, консервативна</translation>
    </message>
    <message>
        <source>refined distance map</source>
        <translation>уточнена карта відстаней</translation>
    </message>
    <message>
        <source>refined distance map, sampled</source>
        <translation>уточнена карта відстаней, вибіркова</translation>
    </message>
    <message>
        <source>every cell</source>
        <translation>кожна комірка</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>плоска поверхня</translation>
    </message>
    <message>
        <source>layers, secant</source>
        <translation>шари, січна</translation>
    </message>
    <message>
        <source>layers, bisection</source>
        <translation>шари, ділення навпіл</translation>
    </message>
    <message>
        <source>max pyramid</source>
        <translation>MIP-піраміда</translation>
    </message>
    <message>
        <source>max pyramid, the paper&apos;s recursion</source>
        <translation>MIP-піраміда, рекурсія</translation>
    </message>
    <message>
        <source>normal mapping</source>
        <translation>карта нормалей (normal mapping)</translation>
    </message>
    <message>
        <source>parallax offset</source>
        <translation>зміщення за паралаксом</translation>
    </message>
    <message>
        <source>parallax offset, limited</source>
        <translation>зміщення за паралаксом, обмежене</translation>
    </message>
    <message>
        <source>relaxed cone steps</source>
        <translation>розширені конуси</translation>
    </message>
    <message>
        <source>hybrid</source>
        <translation>гібрид</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Біти</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>висоти</translation>
    </message>
    <message>
        <source>weight function of the texels in a footprint</source>
        <translation>вагова функція текселів проєкції пікселя</translation>
    </message>
    <message>
        <source>standard deviation of the Gaussian pixel model</source>
        <translation>стандартне відхилення гаусівської моделі пікселя</translation>
    </message>
    <message>
        <source>radius of the footprint (0: chosen to suit the weights)</source>
        <translation>радіус проєкції пікселя; 0: радіус, що відповідає ваговій функції</translation>
    </message>
    <message>
        <source>pyramid: the level is chosen by the footprint&apos;s minor axis; exhaustive: always level 0</source>
        <translation>pyramid: рівень вибирають за малою віссю проєкції пікселя; exhaustive: завжди рівень 0</translation>
    </message>
    <message>
        <source>smallest minor semi-axis, on the chosen level, of the ellipse onto which a circle of radius 1 pixel projects</source>
        <translation>найменша допустима мала піввісь еліпса, у який проєктується коло радіуса 1 піксель, на вибраному рівні</translation>
    </message>
    <message>
        <source>largest ratio of the axes (longer footprints are widened)</source>
        <translation>найбільше відношення осей; довші проєкції розширюються</translation>
    </message>
    <message>
        <source>whether the Gaussian accounts for the size of texels</source>
        <translation>чи враховує гаусівська модель розмір текселів</translation>
    </message>
    <message>
        <source>source of the weights: the formula, a table over the distance, or a weight map of the pixel</source>
        <translation>джерело вагових коефіцієнтів: формула, таблиця за відстанню чи текстурна карта вагових коефіцієнтів</translation>
    </message>
    <message>
        <source>cells along each side of the weight map (the table has as many cells as the whole map)</source>
        <translation>роздільна здатність карти вагових коефіцієнтів за кожною стороною; таблиця за відстанню має стільки комірок, скільки вся карта</translation>
    </message>
    <message>
        <source>lanes: many pixels at once with SIMD, from 16-bit levels, if source=direct; scalar: one pixel at a time, in double</source>
        <translation>lanes: багато пікселів одночасно (SIMD), за 16-бітовими рівнями, якщо source=direct; scalar: по одному пікселю, з подвійною точністю</translation>
    </message>
    <message>
        <source>place of a texel within the pixel. plane: its point on the polygon&apos;s plane, as in the paper; position: its point on the relief; position-area: the same, weighted by its visible area; rays, grid: the points that rays through parts of the pixel see, traced for each pixel alone or shared with its neighbours</source>
        <translation>місце текселя в пікселі. plane: на площині полігона, як у статті; position: на рельєфі; position-area: те саме з видимою площею; rays, grid: точки, які видно променям крізь частини пікселя, власним для кожного пікселя чи спільним із сусідами</translation>
    </message>
    <message>
        <source>form=rays: rays through each pixel in which the relief is not planar</source>
        <translation>form=rays: променів крізь піксель, у якому рельєф не є площиною</translation>
    </message>
    <message>
        <source>form=grid: points sampled for each pixel in which the relief is not planar</source>
        <translation>form=grid: точок на піксель там, де рельєф не є площиною</translation>
    </message>
    <message>
        <source>the four texels around the point, interpolated bilinearly</source>
        <translation>білінійна фільтрація: чотири текселі навколо точки, ваговий коефіцієнт тим більший, чим ближчий тексель</translation>
    </message>
    <message>
        <source>computation of footprints. direct: from the derivatives of each pixel, in double; iterative, cached: along rows in float ([TEX]), by differences or by cached squares; slower</source>
        <translation>обчислення проєкцій пікселів. direct: за похідними кожного пікселя, з подвійною точністю; iterative, cached: уздовж рядків з одинарною точністю ([TEX]), різницями чи збереженими квадратами; повільніше</translation>
    </message>
    <message>
        <source>all texels in the elliptical footprint of the pixel, weighted by the pixel model</source>
        <translation>анізотропна фільтрація: усі текселі в еліпсі — проєкції пікселя — з ваговими коефіцієнтами за моделлю пікселя</translation>
    </message>
    <message>
        <source>the elliptical filter without the texels that the relief hides from the viewer</source>
        <translation>анізотропна фільтрація без текселів, які перекриває рельєф (зворотне трасування променя)</translation>
    </message>
    <message>
        <source>many rays per pixel, each traced and lit by itself; the reference for pictures, slow</source>
        <translation>надвибірка: багато променів на піксель, кожен трасовано й освітлено окремо; еталон зображення, повільно</translation>
    </message>
    <message>
        <source>two levels of the mean pyramid, chosen by the longer side of the pixel&apos;s projection</source>
        <translation>трилінійна фільтрація: два рівні MIP-піраміди середніх значень, за довшою стороною проєкції пікселя</translation>
    </message>
    <message>
        <source>searching for pixels</source>
        <translation>пошук пікселів</translation>
    </message>
    <message>
        <source>Steps to the edge of the empty cone that the map stores above each cell. Below the cone&apos;s apex the cell is skipped if the ray stays above it, and tested otherwise.</source>
        <translation>Просувається до межі конуса, який за картою порожній над коміркою; нижче його вершини комірку пропускають, якщо промінь лишається над нею, інакше перевіряють.</translation>
    </message>
    <message>
        <source>packed: four square cones per cell, compact and fast; texel: one round cone per cell, as game engines store them. Using sectors, a precision or a map file selects texel</source>
        <translation>packed: чотири квадратні конуси на комірку, компактно й швидко; texel: один круглий конус на комірку, як в ігрових рушіях. Сектори, точність зберігання або файл карти вибирають texel</translation>
    </message>
    <message>
        <source>number of azimuth sectors with separate slopes</source>
        <translation>кількість азимутальних секторів з окремими нахилами конусів</translation>
    </message>
    <message>
        <source>storage format of the cones</source>
        <translation>формат зберігання конусів</translation>
    </message>
    <message>
        <source>Steps to the edge of the interpolated cone a fixed number of times.</source>
        <translation>Просувається до межі інтерпольованого конуса; кількість кроків стала.</translation>
    </message>
    <message>
        <source>Steps to the edge of wider cones, in which a ray crosses the surface at most once; then bisects the last step.</source>
        <translation>Ширші конуси: точка виходу променя з конуса може лежати під поверхнею, але перетинає він її щонайбільше раз; далі останній крок ділять навпіл.</translation>
    </message>
    <message>
        <source>number of bisections of the last step</source>
        <translation>кількість поділів останнього кроку навпіл</translation>
    </message>
    <message>
        <source>search radius for the obstacles that limit a cone</source>
        <translation>до якої відстані шукають перешкоди для конуса</translation>
    </message>
    <message>
        <source>number of azimuths along which cones are measured</source>
        <translation>кількість напрямків, уздовж яких вимірюють конуси</translation>
    </message>
    <message>
        <source>A triangle mesh whose vertices lie at the heights; frames rasterise it with a depth buffer.</source>
        <translation>Сітка трикутників, вершини якої підняті на висоти карти (displacement mapping); кадр растеризують із буфером глибини.</translation>
    </message>
    <message>
        <source>number of quads along each side of the texture</source>
        <translation>кількість чотирикутників уздовж кожної сторони текстури</translation>
    </message>
    <message>
        <source>Sphere tracing with trilinearly interpolated distances until the ray reaches the surface.</source>
        <translation>Метод Доннеллі: трасування сферами за трилінійно інтерпольованими відстанями, доки промінь не дійде до поверхні.</translation>
    </message>
    <message>
        <source>Sphere tracing with distances that are safe for whole voxels; near the surface the cells themselves are tested.</source>
        <translation>Трасування сферами з відстанями, що справджуються для всього об’єму вокселя; біля поверхні перевіряють самі комірки.</translation>
    </message>
    <message>
        <source>The refined map as published, computed from sampled rays; can overshoot at walls.</source>
        <translation>Уточнена карта зі статей без змін, за вибірковими променями; біля стінок можливий проскок за поверхню.</translation>
    </message>
    <message>
        <source>Sphere tracing with the larger distances that are valid for rays from above; safe for whole voxels.</source>
        <translation>Трасування сферами з більшими відстанями для видових променів згори; вони справджуються для всього об’єму вокселя.</translation>
    </message>
    <message>
        <source>number of voxel layers in the slab</source>
        <translation>кількість вокселів за висотою товщі рельєфу</translation>
    </message>
    <message>
        <source>storage format of the distances</source>
        <translation>формат зберігання відстаней</translation>
    </message>
    <message>
        <source>lowest elevation of the rays for which the map is valid</source>
        <translation>кут піднесення найпологішого променя, для якого карта справджується</translation>
    </message>
    <message>
        <source>number of azimuth sectors in which the occluders of a voxel are searched</source>
        <translation>кількість азимутальних секторів, у яких шукають перешкоди, що перекривають воксель</translation>
    </message>
    <message>
        <source>number of azimuth sectors with separate distances (a divisor of horizons)</source>
        <translation>кількість азимутальних секторів з окремими відстанями (дільник кількості секторів горизонту)</translation>
    </message>
    <message>
        <source>number of rays sampled from each voxel</source>
        <translation>кількість вибіркових променів із кожного вокселя</translation>
    </message>
    <message>
        <source>start of a step by the stored distance. exit: where the ray leaves the voxel; classic: the ray&apos;s current point</source>
        <translation>початок кроку на збережену відстань. exit: точка виходу променя з вокселя; classic: поточна точка</translation>
    </message>
    <message>
        <source>end of the march: at the surface, where the distance is below `within`, or only after all iterations</source>
        <translation>де закінчується трасування: на поверхні, там, де відстань менша за `within`, або лише після всіх ітерацій</translation>
    </message>
    <message>
        <source>distance below which stop=distance ends the march</source>
        <translation>відстань, за якої закінчує stop=distance</translation>
    </message>
    <message>
        <source>largest number of steps (stop=never takes all of them)</source>
        <translation>найбільша кількість кроків; за stop=never виконуються всі</translation>
    </message>
    <message>
        <source>target of the Euclidean distances: the surface, or the centre of the nearest solid voxel</source>
        <translation>до чого вимірюють евклідові відстані: до поверхні чи до центра найближчого заповненого вокселя</translation>
    </message>
    <message>
        <source>map used for tracing</source>
        <translation>карта, за якою виконується трасування</translation>
    </message>
    <message>
        <source>largest number of steps</source>
        <translation>найбільша кількість кроків</translation>
    </message>
    <message>
        <source>Tests every cell that the ray crosses, in order; the reference for all other methods.</source>
        <translation>Перевіряє по черзі кожну комірку, яку перетинає промінь: еталон, з яким порівнюють інші методи.</translation>
    </message>
    <message>
        <source>Plain texturing without relief; lighting uses the flat polygon.</source>
        <translation>Звичайне текстурування: без рельєфу, освітлення як у полігона.</translation>
    </message>
    <message>
        <source>The surface stays flat; lighting uses the slopes of the heights.</source>
        <translation>Геометрія лишається плоскою; освітлення враховує нахили карти висот (bump mapping).</translation>
    </message>
    <message>
        <source>The surface stays flat; lighting uses a normal map, either given or computed from the heights.</source>
        <translation>Геометрія лишається плоскою; освітлення враховує карту нормалей, задану або обчислену з висот (normal mapping).</translation>
    </message>
    <message>
        <source>number of layers in the slab</source>
        <translation>кількість шарів у товщі рельєфу</translation>
    </message>
    <message>
        <source>number of bisections of the last layer</source>
        <translation>кількість поділів останнього шару навпіл</translation>
    </message>
    <message>
        <source>Layers of equal depth; the answer is the first one below the surface.</source>
        <translation>Шари однакової товщини; відповідь — перший шар, нижчий за поверхню.</translation>
    </message>
    <message>
        <source>Layers of equal depth, then a straight line between the last two.</source>
        <translation>Шари однакової товщини, потім пряма між двома останніми.</translation>
    </message>
    <message>
        <source>Layers of equal depth, then bisection of the last one.</source>
        <translation>Шари однакової товщини, потім ділення останнього навпіл.</translation>
    </message>
    <message>
        <source>Skips areas below the ray with a pyramid of maxima; iterative, without a stack.</source>
        <translation>Пропускає ділянки, що лежать нижче за промінь, за допомогою MIP-піраміди максимальних значень; ітеративно, без стека.</translation>
    </message>
    <message>
        <source>Skips areas below the ray with a pyramid of maxima; recursive, as in the paper.</source>
        <translation>Пропускає ділянки, що лежать нижче за промінь, за допомогою MIP-піраміди максимальних значень; рекурсивно, як у [MIP18].</translation>
    </message>
    <message>
        <source>One sample: the ray advances to the height sampled where it enters.</source>
        <translation>Зміщення за один відлік: промінь продовжують до висоти, прочитаної в точці входу.</translation>
    </message>
    <message>
        <source>One sample, with the shift limited to the depth of the relief.</source>
        <translation>Один відлік, з обмеженням зміщення: воно не довше за глибину рельєфу.</translation>
    </message>
    <message>
        <source>base level: above 0, this level of the mean pyramid is traced instead of the heights (the top level if there are fewer); auto: the highest level whose texels are no wider than the narrowest pixel of the view</source>
        <translation>базовий MIP-рівень: якщо більший за 0, замість висот трасують рівень MIP-піраміди середніх значень (останній, якщо рівнів менше); auto: найвищий рівень, текселі якого не ширші за найвужчу проєкцію пікселя цього ракурсу</translation>
    </message>
    <message>
        <source>One level of the max pyramid marks the segments worth testing; the inner method searches them, and its guarantee holds. This mostly takes more steps than the inner method alone: compare the two.</source>
        <translation>Один рівень MIP-піраміди максимальних значень виділяє відрізки, які варто перевірити; їх досліджує внутрішній метод, і діє його гарантія. Кроків здебільшого більше, ніж у самого внутрішнього методу: порівняйте обидва.</translation>
    </message>
    <message>
        <source>middle level (the top level if there are fewer)</source>
        <translation>середній рівень (найвищий, якщо рівнів менше)</translation>
    </message>
    <message>
        <source>method that searches the segments; its own options are given as inner.NAME</source>
        <translation>метод усередині відрізків; його параметри: inner.НАЗВА</translation>
    </message>
    <message>
        <source>u and v are linear along the row, without perspective; deliberately wrong.</source>
        <translation>Афінне текстурування: u, v змінюються вздовж рядка лінійно, без перспективи; навмисно неправильно.</translation>
    </message>
    <message>
        <source>(A x + B y + C) / (G x + H y + I); the denominator is computed separately for u and v.</source>
        <translation>Метод Хекберта: (A x + B y + C) / (G x + H y + I), знаменник обчислюється окремо для u та для v.</translation>
    </message>
    <message>
        <source>(u_t + A n) / (u_b + G n); the terms that are constant along a row are computed once.</source>
        <translation>(u_t + A n) / (u_b + G n): сталі для рядка частини чисельника та знаменника обчислено один раз ([PERSP]).</translation>
    </message>
    <message>
        <source>elevation of the camera above the horizontal</source>
        <translation>кут камери над горизонтом</translation>
    </message>
    <message>
        <source>rotation of the camera to the right (0: in front)</source>
        <translation>наскільки камера повернута праворуч, 0 — спереду</translation>
    </message>
    <message>
        <source>distance from the camera to its target</source>
        <translation>від камери до того, на що вона спрямована</translation>
    </message>
    <message>
        <source>direction from which the light comes (0: from the front)</source>
        <translation>звідки падає світло, 0 — спереду</translation>
    </message>
    <message>
        <source>elevation of the light above the horizontal</source>
        <translation>кут світла над горизонтом</translation>
    </message>
    <message>
        <source>share of ambient light, from all directions</source>
        <translation>частка світла, що йде звідусіль</translation>
    </message>
    <message>
        <source>strength of the directional light</source>
        <translation>сила світла, що падає з одного напрямку</translation>
    </message>
    <message>
        <source>largest hit error allowed to save work (the actual error is measured)</source>
        <translation>допустима похибка точки перетину там, де це заощаджує обчислення; фактичну похибку вимірюють</translation>
    </message>
    <message>
        <source>model of a display pixel: the weight function of the samples</source>
        <translation>модель пікселя екрана: вагова функція вибірок</translation>
    </message>
    <message>
        <source>the heights as read from the file</source>
        <translation>висоти, як їх прочитано</translation>
    </message>
    <message>
        <source>heights rounded to a number of bits, as in files of integers</source>
        <translation>висоти, округлені до заданої кількості бітів, як у файлах цілих чисел</translation>
    </message>
    <message>
        <source>bits per height: 2^bits uniform values from 0 to 1</source>
        <translation>бітів на висоту: 2 у степені цього числа значень, рівномірно від 0 до 1</translation>
    </message>
    <message>
        <source>Divides every m pixels and interpolates u and v linearly in between; m is given, or the largest that keeps a given error.</source>
        <translation>Ділення через кожні m пікселів, між ними u та v лінійні; m задане або найбільше, за якого похибка не перевищує заданої.</translation>
    </message>
    <message>
        <source>w += A, q += G, with a separate denominator for u and v. Restarts from an exact value every anchor pixels; otherwise the error accumulates.</source>
        <translation>w += A, q += G, знаменник окремо для u та для v. Через кожні anchor пікселів (перезапуск) обчислюється точне значення; без цього похибка накопичується.</translation>
    </message>
    <message>
        <source>As incremental, but with one q for u and v. Restarts from an exact value every anchor pixels; otherwise the error accumulates.</source>
        <translation>Те саме з одним q для u та v. Через кожні anchor пікселів (перезапуск) обчислюється точне значення; без цього похибка накопичується.</translation>
    </message>
    <message>
        <source>As incremental, but with one 1 / q for u and v. Restarts from an exact value every anchor pixels; otherwise the error accumulates.</source>
        <translation>Те саме з одним 1 / q для u та v. Через кожні anchor пікселів (перезапуск) обчислюється точне значення; без цього похибка накопичується.</translation>
    </message>
    <message>
        <source>Computes pixel n from pixel n - k, in k streams at once; 2, 4, 8, 16 and 32 streams use SIMD. Restarts from an exact value every anchor pixels; otherwise the error accumulates.</source>
        <translation>Піксель n із пікселя n - k, k потоків одночасно; 2, 4, 8, 16 та 32 обчислюються у векторних регістрах (SIMD). Через кожні anchor пікселів (перезапуск) обчислюється точне значення; без цього похибка накопичується.</translation>
    </message>
    <message>
        <source>Computes from both ends of the row towards its middle. Restarts from an exact value every anchor pixels; otherwise the error accumulates.</source>
        <translation>Від обох кінців рядка до середини. Через кожні anchor пікселів (перезапуск) обчислюється точне значення; без цього похибка накопичується.</translation>
    </message>
    <message>
        <source>Interleaved streams; several threads share the rows. Restarts from an exact value every anchor pixels; otherwise the error accumulates.</source>
        <translation>Почергові потоки в рядку; самі рядки паралельно растеризує кілька потоків процесора. Через кожні anchor пікселів (перезапуск) обчислюється точне значення; без цього похибка накопичується.</translation>
    </message>
    <message>
        <source>number of samples along each side of a pixel</source>
        <translation>вибірок уздовж кожної сторони пікселя</translation>
    </message>
    <message>
        <source>width of the picture</source>
        <translation>ширина зображення</translation>
    </message>
    <message>
        <source>height of the picture</source>
        <translation>висота зображення</translation>
    </message>
    <message>
        <source>lowest elevation of the rays for which the map is valid; needs map=refined</source>
        <translation>кут піднесення найпологішого променя, для якого карта справджується; потребує map=refined</translation>
    </message>
    <message>
        <source>number of azimuth sectors in which the occluders of a voxel are searched; needs map=refined</source>
        <translation>кількість азимутальних секторів, у яких шукають перешкоди, що перекривають воксель; потребує map=refined</translation>
    </message>
    <message>
        <source>number of azimuth sectors with separate distances (a divisor of horizons); needs map=refined</source>
        <translation>кількість азимутальних секторів з окремими відстанями (дільник кількості секторів горизонту); потребує map=refined</translation>
    </message>
    <message>
        <source> px</source>
        <translation> пікс.</translation>
    </message>
    <message>
        <source>bilinear</source>
        <translation>білінійний</translation>
    </message>
    <message>
        <source>elliptical</source>
        <translation>анізотропний</translation>
    </message>
    <message>
        <source>elliptical, visible</source>
        <translation>анізотропний, лише видиме</translation>
    </message>
    <message>
        <source>nearest texel</source>
        <translation>найближчий тексель</translation>
    </message>
    <message>
        <source>supersampling</source>
        <translation>надвибірка</translation>
    </message>
    <message>
        <source>trilinear</source>
        <translation>трилінійний</translation>
    </message>
    <message>
        <source>bricks</source>
        <translation>цегла</translation>
    </message>
    <message>
        <source>spikes</source>
        <translation>голки</translation>
    </message>
    <message>
        <source>pits</source>
        <translation>ями</translation>
    </message>
    <message>
        <source>thin columns</source>
        <translation>тонкі стовпи</translation>
    </message>
    <message>
        <source>city</source>
        <translation>місто</translation>
    </message>
    <message>
        <source>fractal terrain</source>
        <translation>фрактальний рельєф</translation>
    </message>
    <message>
        <source>hills</source>
        <translation>пагорби</translation>
    </message>
    <message>
        <source>terraces</source>
        <translation>тераси</translation>
    </message>
    <message>
        <source>checkerboard</source>
        <translation>шахівниця</translation>
    </message>
    <message>
        <source>the paper&apos;s 8 × 8</source>
        <translation>приклад 8 × 8</translation>
    </message>
    <message>
        <source>walls and a trench</source>
        <translation>стіни й рів</translation>
    </message>
    <message>
        <source>cone steps, corrected</source>
        <translation>конуси, виправлені</translation>
    </message>
    <message>
        <source>relaxed cone steps, corrected</source>
        <translation>розширені конуси, виправлені</translation>
    </message>
    <message>
        <source>Steps to the edge of the interpolated cone a fixed number of times, over cones that are safe between texels, too.</source>
        <translation>Просувається до межі інтерпольованого конуса; кількість кроків стала, а конуси надійні й між текселями.</translation>
    </message>
    <message>
        <source>Steps to the edge of relaxed cones that no texel behind which the surface falls stands in; then bisects the last step.</source>
        <translation>Розширені конуси, у яких немає жодного текселя, за яким поверхня спадає; останній крок ділять навпіл.</translation>
    </message>
    <message>
        <source>map cone-robust</source>
        <translation>карта конусів: cone-robust</translation>
    </message>
    <message>
        <source>map relaxed-cone-robust</source>
        <translation>карта конусів: relaxed-cone-robust</translation>
    </message>
</context>
</TS>
