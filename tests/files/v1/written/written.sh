#!/usr/bin/env bash
# How the files here were written, by the program of commit 978dea3:   written.sh BIN SOURCES   (in an empty folder;
# needs jq, oiiotool, xvfb-run, xdotool). Not to be run again: newer programs write their own folder, v2.
set -euo pipefail
export PATH=$1:$PATH LC_ALL=C
mkdir pictures rendered traced maps tables lessons
relief make bricks --size 24x16 --seed 3 -o pictures/height.png
relief render --relief city:32x32:2 --size 24x16 -o pictures/color.png
relief render --relief hills:16x16 --size 24x16 --layers normal -o n.exr
oiiotool n.exr --mulc 0.5 --addc 0.5 -d uint8 -o pictures/normal.png
# A scenario as the program writes it: the one in its report.
kept() { # NAME, render's arguments
    local name=$1
    shift
    relief render -q "$@" -o rendered/"$name".png --report "$name.report.json"
    jq .scenario "$name.report.json" >"$name.json"
    rm "$name.report.json"
}
small=(--size 24x18 --relief-depth 0.2)
reliefs=(bricks:16x12:2 spikes:16x16 pits:16x16 columns:16x16 city:16x16:5 fractal:16x16 hills:16x16 steps:16x16 checker:16x16 paper8x8:8x8)
# Every method, none of its options as it is by default.
n=0
while read -r name options; do
    # shellcheck disable=SC2086
    kept "method-$name" "${small[@]}" --relief "${reliefs[n++ % 10]}" --tracer "$name" $options
done <<END
exact
max-pyramid --set base=1
max-pyramid-paper --set base=1
offset
offset-limited
layers --set layers=9
layers-secant --set layers=9
layers-bisection --set layers=9 --set bisections=3
cone --set sectors=4 --set precision=u16
cone-dummer --set iterations=7 --set precision=u8
relaxed-cone --set iterations=6 --set bisections=3 --set radius=8 --set directions=8 --set precision=u16
distance --set footprint=2 --set layers=8 --set precision=u16 --set iterations=9
distance-conservative --set footprint=2 --set layers=8 --set precision=u8 --set rule=classic
distance-refined-sampled --set footprint=2 --set layers=8 --set precision=u8 --set flattest=20 --set directions=32 --set iterations=9
distance-refined --set footprint=2 --set layers=8 --set precision=u8 --set flattest=20 --set horizons=8 --set sectors=4 --set rule=classic
hybrid --set level=2 --set inner=distance-refined --set inner.layers=8
flat
bump
normal-map
displacement --set density=12
END
# Every filter with its options, and the pixel models.
while read -r name options; do
    # shellcheck disable=SC2086
    kept "filter-$name" "${small[@]}" --relief city:16x16:5 --color pictures/color.png $options
done <<END
nearest --filter nearest --scene cube
bilinear --filter bilinear --surface columns --address border --scene wall
trilinear --filter trilinear --address clamp --bounded 0.25 --no-skip
elliptical --filter elliptical:weights=uniform:radius=0.6:levels=exhaustive:floor=2:anisotropy=4
elliptical-map --filter elliptical:weights=gaussian:sigma=0.7:texel-size=off:source=map:resolution=32:implementation=scalar
elliptical-visible --filter elliptical-visible:form=rays:samples=8
elliptical-visible-grid --filter elliptical-visible:form=grid:points=2
elliptical-visible-area --filter elliptical-visible:form=position-area:weights=texel-distance
supersample-box --supersample 3 --pixel-model box
supersample-gaussian --supersample 2 --pixel-model gaussian
supersample-lcd --supersample 3 --pixel-model lcd
supersample-crt --supersample 3 --pixel-model crt
END
kept drawn --size 24x18 --relief drawn:4x3:0,0.25,0.5,1,0.125,1,0,0.75,1,0,0.5,0.25 --relief-depth 0.3
kept profile --size 24x18 --relief drawn:4x3:0,1,0.25,0.5 --relief-depth 0.3
# Rays, hits, steps, maps.
printf '%s\n' s0,t0,a,b 0.5,0.5,3,1 12.25,7.75,-5,2.5 -3,100.125,0,0 20,3,9,-14 6.5,6.5,0.001,-40 23.9,15.9,30,30 \
    >traced/rays.csv
on=(--height pictures/height.png --relief-depth 0.2)
traced() { # NAME, trace's arguments
    relief trace -q "${on[@]}" --rays traced/rays.csv -o "traced/hits-$1.csv" --steps "traced/steps-$1.${2}" "${@:3}"
}
traced max-pyramid csv --tracer max-pyramid
traced exact json --tracer exact
traced layers csv --tracer layers --set layers=12
traced offset json --tracer offset
traced border csv --tracer max-pyramid --address border
traced limit json --tracer cone-dummer --set iterations=1
map() { # NAME KIND "TRACER and its options" options of map
    relief map "$2" "${on[@]}" "${@:4}" -o "maps/$1.tif" >/dev/null
    # shellcheck disable=SC2086
    traced "$1" json --map "maps/$1.tif" --tracer $3
}
map euclidean euclidean "distance --set iterations=8" --set layers=8
map euclidean-conservative euclidean-conservative distance-conservative --set footprint=2 --set layers=8 --set precision=u16
map refined-sampled refined-sampled "distance-refined-sampled --set iterations=8" --set layers=8 --set directions=32
map refined refined distance-refined --set layers=8 --set sectors=4 --set precision=u8
map cone cone cone
map cone-sectors cone cone --set sectors=4 --set precision=u16
map cone-dummer cone-dummer "cone-dummer --set iterations=8" --set precision=u8
map relaxed-cone relaxed-cone "relaxed-cone --set bisections=4" --set radius=16
# A scenario that uses everything, as the window saves it when it is closed; a certificate's counter-example; a report.
mkdir -p home/.config/reliefscope
cp -r pictures traced home/.config/reliefscope/
cp "$(dirname "$0")/everything.json" home/.config/reliefscope/last.json
# shellcheck disable=SC2016
HOME=$PWD/home XDG_CONFIG_HOME=$PWD/home/.config xvfb-run -a -s "-screen 0 1280x720x24" bash -c '
    reliefscope & sleep 15; xdotool search --onlyvisible --name Reliefscope windowfocus --sync key ctrl+q; wait'
cp home/.config/reliefscope/last.json window.json
rm -rf home n.exr
relief render -q window.json -o rendered/window.png
# The other words that the panes know.
n=0
while read -r change; do
    jq "$change" window.json >notes.json
    kept "notes-$((++n))" notes.json
    rm "rendered/notes-$n.png" notes.json
done <<'END'
.compare.mode="flicker" | .compare.difference="flip" | .compare.reference="exact" | .panes.pyramid.levels="min" | .panes.distance={map:"cone",axis:"x"} | .panes.charts={shown:"pareto",error:"max"} | .panes.trace.colors="phase" | .panes.rows.variants=["affine","row-constant","incremental:anchor=0","incremental-shared"]
.compare.mode="difference" | .panes.pyramid.levels="all" | .panes.distance={map:"cone-dummer",minus:"relaxed-cone",axis:"z"} | .panes.charts.error="p9999" | .panes.rows.variants=["incremental-reciprocal","opposed:anchor=0","rows-parallel:streams=8","fill"]
.compare.mode="tiles" | .panes.distance={map:"euclidean",minus:"refined-sampled",sector:3} | .panes.rows.variants=["subspan:span=8","derivatives-direct","derivatives-iterative","derivatives-cached"]
END
relief certify -q --relief spikes:16x16 --relief-depth 0.3 --tracer cone-dummer --set precision=u8 --rays 20000 \
    -o witness.json >/dev/null || [ $? = 1 ]
relief render -q "${on[@]}" --color pictures/color.png --size 24x18 --tracer cone --filter elliptical-visible --shadows \
    -o rendered/report.png --report report.json
# Tables, and a sweep that was killed.
bench=(tracers --relief bricks:16x16 --relief spikes:16x16 --rays 200 --threads 1 --elevations 60,random
    --tracers exact,layers:layers=12,distance-refined:layers=8 -q)
relief bench "${bench[@]}" --rounds 1 -o tables/tracers.csv
relief bench "${bench[@]}" --rounds 1 -o tables/tracers.json
relief bench rows --widths 100 --elevations 25 --variants direct,streams:streams=4,derivatives-direct --pixels 1000 \
    --rounds 1 --threads 1 -q -o tables/rows.csv
relief bench filters --scenes bricks --filters bilinear,elliptical:weights=uniform --elevations 60 --size 12x8 --samples 3 \
    --rounds 1 --threads 1 -q -o tables/filters.csv
relief bench "${bench[@]}" --rounds 500 -o tables/sweep.csv &
until [ "$(grep -c '"part"' tables/sweep.csv.part 2>/dev/null)" = 2 ]; do sleep 0.002; done
kill -9 $!
wait $! || true
mv tables/sweep.csv.part tables/sweep.journal
cp "$2"/ui/lessons/*.json lessons/
