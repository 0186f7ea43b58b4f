<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk_UA">
<context>
    <name>core</name>
    <message>
        <source>a step by the distance: from where the ray leaves the voxel, or from where it is</source>
        <translation>крок на відстань: звідти, де промінь виходить із вокселя, або звідти, де він є</translation>
    </message>
    <message>
        <source>u, v linear along the row, no perspective: wrong on purpose.</source>
        <translation>u, v лінійні вздовж рядка, без перспективи: навмисно хибно.</translation>
    </message>
    <message>
        <source>(A x + B y + C) / (G x + H y + I), the denominator made for each of u and v.</source>
        <translation>(A x + B y + C) / (G x + H y + I), знаменник обчислюється окремо для u та для v.</translation>
    </message>
    <message>
        <source>(u_t + A n) / (u_b + G n): what does not change along a row once.</source>
        <translation>(u_t + A n) / (u_b + G n): що вздовж рядка не змінюється, обчислюється раз.</translation>
    </message>
    <message>
        <source>w += A, q += G, a denominator for each of u and v. Starts again from an exact value every anchor pixels; without that it drifts.</source>
        <translation>w += A, q += G, знаменник окремо для u та для v. Щоразу через anchor пікселів починає наново з точного значення; без цього відхиляється.</translation>
    </message>
    <message>
        <source>The same with one q for u and v. Starts again from an exact value every anchor pixels; without that it drifts.</source>
        <translation>Те саме з одним q для u та v. Щоразу через anchor пікселів починає наново з точного значення; без цього відхиляється.</translation>
    </message>
    <message>
        <source>The same with one 1 / q for u and v. Starts again from an exact value every anchor pixels; without that it drifts.</source>
        <translation>Те саме з одним 1 / q для u та v. Щоразу через anchor пікселів починає наново з точного значення; без цього відхиляється.</translation>
    </message>
    <message>
        <source>Pixel n from pixel n - k, k streams at once; 2, 4, 8, 16 and 32 run in vector lanes. Starts again from an exact value every anchor pixels; without that it drifts.</source>
        <translation>Піксель n із пікселя n - k, k потоків разом; 2, 4, 8, 16 та 32 ідуть у векторних смугах. Щоразу через anchor пікселів починає наново з точного значення; без цього відхиляється.</translation>
    </message>
    <message>
        <source>From both ends of the row to its middle. Starts again from an exact value every anchor pixels; without that it drifts.</source>
        <translation>Від обох кінців рядка до середини. Щоразу через anchor пікселів починає наново з точного значення; без цього відхиляється.</translation>
    </message>
    <message>
        <source>Interleaved streams, the rows by several threads. Starts again from an exact value every anchor pixels; without that it drifts.</source>
        <translation>Чергування потоків, рядки у кількох нитках процесора. Щоразу через anchor пікселів починає наново з точного значення; без цього відхиляється.</translation>
    </message>
    <message>
        <source>A division every m pixels, u and v linear between; m as given, or the longest that keeps an error.</source>
        <translation>Ділення кожні m пікселів, між ними u та v лінійні; m задане або найдовше, що зберігає похибку.</translation>
    </message>
    <message>
        <source>Steps to the edge of the cone that the map promises to be empty above each cell; below its apex the cell is skipped if the ray stays above it, else tested.</source>
        <translation>Просувається до краю конуса, який карта обіцяє порожнім над кожною коміркою; нижче його вершини комірку пропускають, якщо промінь над нею, інакше перевіряють.</translation>
    </message>
    <message>
        <source>packed: four square cones per cell, compact and fast; texel: one round cone per cell, as engines store them. Sectors, a precision or a map file select texel</source>
        <translation>packed: чотири квадратні конуси на комірку, компактно й швидко; texel: один круглий конус на комірку, як в ігрових рушіях. Сектори, точність або файл карти вибирають texel</translation>
    </message>
    <message>
        <source>azimuth sectors that have slopes of their own</source>
        <translation>сектори азимута з власними нахилами</translation>
    </message>
    <message>
        <source>how cones are stored</source>
        <translation>як зберігаються конуси</translation>
    </message>
    <message>
        <source>Steps to the edge of the interpolated cone, a fixed number of times.</source>
        <translation>Кроки до краю інтерпольованого конуса, сталу кількість разів.</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>щонайбільше</translation>
    </message>
    <message>
        <source>Wider cones that the ray may leave below the surface, once; then halving of the last step.</source>
        <translation>Ширші конуси, з яких промінь може вийти під поверхнею один раз; далі ділення останнього кроку навпіл.</translation>
    </message>
    <message>
        <source>of the last step</source>
        <translation>останнього кроку</translation>
    </message>
    <message>
        <source>how far cones are looked for</source>
        <translation>як далеко шукаються конуси</translation>
    </message>
    <message>
        <source>along which cones are measured</source>
        <translation>уздовж яких вимірюються конуси</translation>
    </message>
    <message>
        <source>Sphere tracing by trilinear distances, until the ray is at the surface.</source>
        <translation>Трасування сферами за трилінійними відстанями, доки промінь не дійде до поверхні.</translation>
    </message>
    <message>
        <source>Sphere tracing with distances that hold for whole voxels; near the surface the cells themselves are tested.</source>
        <translation>Трасування сферами з відстанями, чинними для цілих вокселів; біля поверхні перевіряються самі комірки.</translation>
    </message>
    <message>
        <source>The papers&apos; refined map as it stands, from sampled rays; overshoots at walls.</source>
        <translation>Уточнена карта зі статей як є, за вибірковими променями; біля стін проскакує поверхню.</translation>
    </message>
    <message>
        <source>Sphere tracing with the larger distances that rays from above may use; safe for whole voxels.</source>
        <translation>Трасування сферами з більшими відстанями, чинними для променів зору згори; надійне для цілих вокселів.</translation>
    </message>
    <message>
        <source>side of a voxel&apos;s footprint</source>
        <translation>сторона основи вокселя</translation>
    </message>
    <message>
        <source>how many voxels the slab is high</source>
        <translation>скільки вокселів у висоту шару</translation>
    </message>
    <message>
        <source>how distances are stored</source>
        <translation>як зберігаються відстані</translation>
    </message>
    <message>
        <source>elevation of the flattest ray that it serves</source>
        <translation>кут найпологішого променя, який вона обслуговує</translation>
    </message>
    <message>
        <source>azimuth sectors in which what hides a voxel is looked for</source>
        <translation>сектори азимута, у яких шукається те, що заступає воксель</translation>
    </message>
    <message>
        <source>azimuth sectors that have distances of their own (a divisor of horizons)</source>
        <translation>сектори азимута з власними відстанями (дільник horizons)</translation>
    </message>
    <message>
        <source>sampled from each voxel</source>
        <translation>вибірка з кожного вокселя</translation>
    </message>
    <message>
        <source>at most; with stop=never all</source>
        <translation>щонайбільше; за stop=never — усі</translation>
    </message>
    <message>
        <source>where the march ends: at the surface, where the distance is below `within`, or nowhere</source>
        <translation>де закінчується трасування: на поверхні, там, де відстань менша за `within`, або ніде</translation>
    </message>
    <message>
        <source>of stop=distance</source>
        <translation>для stop=distance</translation>
    </message>
    <message>
        <source>what Euclidean distances are measured to: the surface, or the nearest solid voxel&apos;s centre</source>
        <translation>до чого вимірюються евклідові відстані: до поверхні чи до центра найближчого заповненого вокселя</translation>
    </message>
    <message>
        <source>the map that it traces with</source>
        <translation>карта, за якою він трасує</translation>
    </message>
    <message>
        <source>Relief depth</source>
        <translation>Глибина рельєфу</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Підняття</translation>
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
        <translation>Висота світла</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Розсіяне</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Яскравість</translation>
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
        <translation>товщина шару рельєфу</translation>
    </message>
    <message>
        <source>how high the camera stands above the horizontal</source>
        <translation>наскільки камера піднята над горизонталлю</translation>
    </message>
    <message>
        <source>how far the camera has turned to the right, 0 in front</source>
        <translation>наскільки камера повернута праворуч, 0 — спереду</translation>
    </message>
    <message>
        <source>from the camera to what it looks at</source>
        <translation>від камери до того, на що вона дивиться</translation>
    </message>
    <message>
        <source>vertical field of view</source>
        <translation>вертикальний кут огляду</translation>
    </message>
    <message>
        <source>where the light comes from, 0 in front</source>
        <translation>звідки падає світло, 0 — спереду</translation>
    </message>
    <message>
        <source>how high the light stands</source>
        <translation>наскільки високо стоїть світло</translation>
    </message>
    <message>
        <source>share of the light that comes from everywhere</source>
        <translation>частка світла, що йде звідусіль</translation>
    </message>
    <message>
        <source>strength of the light</source>
        <translation>сила світла</translation>
    </message>
    <message>
        <source>of the picture</source>
        <translation>зображення</translation>
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
        <translation>обережний</translation>
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
        <source>the four texels around the point, weighted by closeness</source>
        <translation>чотири текселі навколо точки, зважені за близькістю</translation>
    </message>
    <message>
        <source>Skips what lies below the ray by the pyramid of maxima; iterative, stackless.</source>
        <translation>Пропускає те, що лежить під променем, за пірамідою максимумів; ітеративно, без стека.</translation>
    </message>
    <message>
        <source>Plain texturing: no relief, lit as the polygon is.</source>
        <translation>Звичайне текстурування: без рельєфу, освітлення як у полігона.</translation>
    </message>
    <message>
        <source>The picture stays flat; the light sees the slopes of the heights.</source>
        <translation>Зображення лишається пласким; світло бачить нахили висот.</translation>
    </message>
    <message>
        <source>The picture stays flat; the light sees a normal map, the given one or one baked from the heights.</source>
        <translation>Зображення лишається пласким; світло бачить карту нормалей: задану або обчислену наперед із висот.</translation>
    </message>
    <message>
        <source>A mesh of triangles at the heights; frames rasterise it with a depth buffer.</source>
        <translation>Сітка трикутників на висотах; кадр растеризує її з буфером глибини.</translation>
    </message>
    <message>
        <source>many rays a pixel, traced and lit one by one: the picture&apos;s truth, slow</source>
        <translation>багато променів на піксель, кожен простежено й освітлено окремо: істина для зображення, повільно</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>проби</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>чотирикутники</translation>
    </message>
    <message>
        <source>along each side of the texture</source>
        <translation>уздовж кожної сторони текстури</translation>
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
        <source>Skips what lies below the ray by the pyramid of maxima; recursive, as the paper tells it.</source>
        <translation>Пропускає те, що лежить під променем, за пірамідою максимумів; рекурсивно, як у статті.</translation>
    </message>
    <message>
        <source>Tests every cell that the ray crosses, in order: the truth that others are held against.</source>
        <translation>Перевіряє по черзі кожну комірку, яку перетинає промінь: істина, з якою порівнюють інші методи.</translation>
    </message>
    <message>
        <source>brick wall in a running bond with deep mortar</source>
        <translation>цегляна стіна з глибокими швами</translation>
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
        <translation>шорсткий рельєф: шум в октавах</translation>
    </message>
    <message>
        <source>smooth hills: a few sines</source>
        <translation>гладкі пагорби: кілька синусоїд</translation>
    </message>
    <message>
        <source>eight terraces with vertical walls</source>
        <translation>вісім терас зі стрімкими стінами</translation>
    </message>
    <message>
        <source>blocks of 0 and 1</source>
        <translation>блоки з 0 та 1</translation>
    </message>
    <message>
        <source>the 8 x 8 example of the max pyramid&apos;s paper</source>
        <translation>приклад 8 × 8 зі статті про піраміду максимумів</translation>
    </message>
    <message>
        <source>two walls with a trench between them: the example of the refined map&apos;s paper</source>
        <translation>дві стіни й рів між ними: приклад зі статті про уточнену карту</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>кадр</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>піраміда</translation>
    </message>
    <message>
        <source>One sample: the ray is taken to the height found where it enters.</source>
        <translation>Один відлік: промінь переноситься на висоту, знайдену там, де він входить.</translation>
    </message>
    <message>
        <source>One sample, the shift never longer than the relief is deep.</source>
        <translation>Один відлік, зсув не довший за глибину рельєфу.</translation>
    </message>
    <message>
        <source>Equal layers of depth; the first one below the surface.</source>
        <translation>Рівні шари за глибиною; перший, що нижче за поверхню.</translation>
    </message>
    <message>
        <source>Equal layers, then a straight line between the last two.</source>
        <translation>Рівні шари, потім пряма між двома останніми.</translation>
    </message>
    <message>
        <source>Equal layers, then halving the last one.</source>
        <translation>Рівні шари, потім ділення останнього навпіл.</translation>
    </message>
    <message>
        <source>One level of the max pyramid marks the segments worth testing; another method works inside them and gives its guarantee. It mostly takes more steps than that method alone: compare the two.</source>
        <translation>Один рівень піраміди максимумів позначає відрізки, які варто перевірити; всередині них працює інший метод і дає свою гарантію. Кроків здебільшого більше, ніж у самого того методу: порівняйте обидва.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Густота</translation>
    </message>
    <message>
        <source>base level: above 0, the mean pyramid&apos;s level is traced instead of the heights (the last if there are fewer); auto: the highest whose texels are no wider than the narrowest pixel of the view</source>
        <translation>базовий рівень: якщо більший за 0, замість висот простежується рівень піраміди середніх (останній, якщо рівнів менше); auto: найвищий, чиї текселі не ширші за найвужчий піксель виду</translation>
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
        <translation>Базовий рівень</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>шарів</translation>
    </message>
    <message>
        <source>halvings</source>
        <translation>поділів</translation>
    </message>
    <message>
        <source>level</source>
        <translation>рівень</translation>
    </message>
    <message>
        <source>how many the slab is cut into</source>
        <translation>на скільки шарів поділено товщу</translation>
    </message>
    <message>
        <source>of the last layer</source>
        <translation>останнього шару</translation>
    </message>
    <message>
        <source>the middle level (the top if there are fewer)</source>
        <translation>середній рівень (вершина, якщо рівнів менше)</translation>
    </message>
    <message>
        <source>the method inside the segments; its own options as inner.NAME</source>
        <translation>метод усередині відрізків; його налаштування: inner.НАЗВА</translation>
    </message>
    <message>
        <source>error against exact</source>
        <translation>похибка проти точного</translation>
    </message>
    <message>
        <source>map euclidean</source>
        <translation>карта euclidean</translation>
    </message>
    <message>
        <source>map euclidean-conservative</source>
        <translation>карта euclidean-conservative</translation>
    </message>
    <message>
        <source>map refined-sampled</source>
        <translation>карта refined-sampled</translation>
    </message>
    <message>
        <source>map refined</source>
        <translation>карта refined</translation>
    </message>
    <message>
        <source>map cone</source>
        <translation>карта cone</translation>
    </message>
    <message>
        <source>map cone-dummer</source>
        <translation>карта cone-dummer</translation>
    </message>
    <message>
        <source>map relaxed-cone</source>
        <translation>карта relaxed-cone</translation>
    </message>
    <message>
        <source>two levels of the mean pyramid, by the longer side of the pixel&apos;s projection</source>
        <translation>два рівні піраміди середніх, за довшою стороною проєкції пікселя</translation>
    </message>
    <message>
        <source>all texels in the ellipse of the pixel, weighted by the pixel&apos;s own shape</source>
        <translation>усі тексели в еліпсі пікселя, зважені за формою самого пікселя</translation>
    </message>
    <message>
        <source>the same without the texels that the relief hides from the viewer</source>
        <translation>те саме без текселів, які рельєф ховає від глядача</translation>
    </message>
    <message>
        <source>how the texels of a footprint are weighed</source>
        <translation>як зважуються тексели сліду</translation>
    </message>
    <message>
        <source>of the Gaussian pixel</source>
        <translation>гаусового пікселя</translation>
    </message>
    <message>
        <source>of the footprint; 0: what suits the weights</source>
        <translation>сліду; 0: той, що пасує до ваг</translation>
    </message>
    <message>
        <source>the level by the footprint&apos;s minor axis, or always level 0</source>
        <translation>рівень за малою віссю сліду або завжди рівень 0</translation>
    </message>
    <message>
        <source>smallest minor semi-axis of the 1-pixel circle on the level chosen</source>
        <translation>найменша мала піввісь кола в 1 піксель на вибраному рівні</translation>
    </message>
    <message>
        <source>largest ratio of the axes; longer footprints get wider</source>
        <translation>найбільше відношення осей; довші сліди ширшають</translation>
    </message>
    <message>
        <source>whether the Gaussian makes allowance for the size of texels</source>
        <translation>чи враховує гаусіана розмір текселів</translation>
    </message>
    <message>
        <source>where weights come from: the formula, a table over the distance, a map of the pixel</source>
        <translation>звідки беруться ваги: формула, таблиця за відстанню чи карта пікселя</translation>
    </message>
    <message>
        <source>of the map of weights along each side; the table has its square</source>
        <translation>карти ваг уздовж кожної сторони; таблиця має її квадрат</translation>
    </message>
    <message>
        <source>many pixels at once, of 16-bit levels, where the formula is direct; or one by one in double</source>
        <translation>багато пікселів разом, за 16-бітними рівнями, де формула пряма; або по одному, з подвійною точністю</translation>
    </message>
    <message>
        <source>where in the pixel a texel counts: its place on the plane (the paper&apos;s), its own, and with its area seen (ours); or what rays through parts of the pixel see, of its own or on a grid that neighbours share (ours; grid: the default)</source>
        <translation>де в пікселі рахується тексель: його місце на площині (як у статті), справжнє, і з видимою площею (наші); або що бачать промені крізь частини пікселя, власні чи на спільній із сусідами сітці (наші; типово сітка)</translation>
    </message>
    <message>
        <source>how footprints are computed: each pixel&apos;s derivatives in double; or along rows in float ([TEX]), by differences or by cached squares; slower</source>
        <translation>як обчислюються сліди: похідними кожного пікселя з подвійною точністю; або вздовж рядків з одинарною ([TEX]), різницями чи збереженими квадратами; повільніше</translation>
    </message>
    <message>
        <source>form=rays: through a pixel in which the relief is no plane</source>
        <translation>form=rays: крізь піксель, у якому рельєф не є площиною</translation>
    </message>
    <message>
        <source>form=grid: looked at for each pixel where the relief is no plane</source>
        <translation>form=grid: на кожен піксель, де рельєф не є площиною</translation>
    </message>
    <message>
        <source>samples along each side of a pixel</source>
        <translation>проб уздовж кожної сторони пікселя</translation>
    </message>
    <message>
        <source>what a pixel of the display is: how samples are weighed</source>
        <translation>що таке піксель екрана: як зважуються проби</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Ваги</translation>
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
        <translation>Джерело ваг</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Роздільність</translation>
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
        <translation>Проби</translation>
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
        <source>what hits may be wrong by where that spares work; its error is measured</source>
        <translation>наскільки можуть хибити влучання там, де це береже роботу; похибку виміряно</translation>
    </message>
    <message>
        <source>looking for pixels</source>
        <translation>пошук пікселів</translation>
    </message>
</context>
</TS>
