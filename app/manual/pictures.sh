#!/usr/bin/env bash
# Makes the pictures of the guide again, with the built programs: app/manual/pictures.sh [BUILD]     default: build
# The chart is timed, so nothing else should run on the machine. With a display (or xvfb-run) also makes ui/window.png.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bin=${1:-build}/bin
out=app/manual/pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# figure NAME FILE VIEW OPTION...: exports a pane as a figure with the width of the manual's text.
figure() {
    local name=$1 file=$2 view=$3
    shift 3
    "$bin/reliefscope" "$file" --export "$view" -o "$out/$name.png" --width 120 --dpi 140 "$@"
}

"$bin/relief" render -q --height datasets/gray_rocks/height.png --color datasets/gray_rocks/color.jpg --scene floor \
    --camera elevation=46,azimuth=20,distance=0.42 --relief-depth 0.05 --light elevation=38,azimuth=-70 --shadows \
    --filter elliptical-visible --size 960x540 -o "$out/rocks.jpg"
figure result ui/lessons/vain_descent.json result
figure profile ui/lessons/vain_descent.json profile
figure pyramid ui/lessons/vain_descent.json pyramid
figure trace ui/lessons/vain_descent.json trace
figure cones datasets/gray_rocks/height.png profile --pixel 400,300 --tracers cone
figure distance ui/lessons/unsafe_distance.json distance
figure duel ui/lessons/missed_spike.json duel
figure footprint ui/lessons/vain_descent.json footprint --filters elliptical-visible

tracers=exact,max-pyramid,cone,distance-refined,layers:layers=16,layers:layers=64,layers:layers=256,layers-bisection
tracers+=,offset,offset-limited,cone-dummer,relaxed-cone,hybrid
"$bin/relief" bench tracers -q --relief fractal:512x512:1 --elevations 25 --threads 1 --rounds 9 --tracers "$tracers" \
    -o "$scratch/bench.json"
"$bin/reliefscope" "$scratch/bench.json" --export pareto -o "$out/pareto.png" --width 200 --dpi 130

if [ -n "${DISPLAY:-}" ]; then
    "$bin/reliefscope" app/manual/window.json --anew --screenshot ui/window.png --size 1600x1000
fi
