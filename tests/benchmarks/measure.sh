#!/usr/bin/env bash
# Measures every table between marks of RESULTS.md and writes it there: these numbers are never typed by hand. The tables
# without marks, which the page's beginning lists, are not measured here.
#   tests/benchmarks/measure.sh [FOLDER [BUILD]]     default: build/measured build
# Resumes after an interruption: results in FOLDER are not measured again. Takes hours on two cores; nothing else should
# run on the machine. Afterwards review the text between the tables, which quotes them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
cd "$root"
folder=${1:-build/measured}
bin=${2:-build}/bin
mkdir -p "$folder"

# NAME COMMAND...: runs a sweep into FOLDER/NAME.csv, unless that exists.
sweep() {
    local file=$folder/$1.csv
    shift
    [ -e "$file" ] && return
    local resume=()
    [ -e "$file.part" ] && resume=(--resume)
    "$bin/relief" bench "$@" "${resume[@]}" -o "$file"
}
# NAME COMMAND...: writes the command's output to FOLDER/NAME.md, unless that exists.
printed() {
    local file=$folder/$1.md
    shift
    [ -e "$file" ] && return
    "$@" >"$file.part"
    [ "$file" = "$folder/claims.md" ] || printf '\n(measured %s)\n' "$(date +%F)" >>"$file.part"
    mv "$file.part" "$file"
}

sweep rows rows --threads 1 --rounds 9
sweep filters_checker filters --scenes checker --size 160x120 --threads 1 --rounds 9 \
    --filters nearest,bilinear,trilinear,elliptical:weights=uniform,elliptical:weights=texel-distance,elliptical,elliptical:implementation=scalar,elliptical:source=table,elliptical:source=map,elliptical:weights=box,elliptical:levels=exhaustive
visible=trilinear,elliptical,elliptical-visible:form=plane,elliptical-visible:form=rays,elliptical-visible:form=grid
sweep filters_procedural filters --scenes bricks,city,hills --size 160x120 --threads 1 --filters $visible \
    --pixel-models gaussian
sweep filters_wall filters --height datasets/stone_wall_bricks102/height.jpg --relief-depth 0.05 --size 160x120 \
    --color datasets/stone_wall_bricks102/color.jpg --threads 1 --filters $visible --pixel-models gaussian
{
    cat "$folder/filters_procedural.csv"
    tail -n +2 "$folder/filters_wall.csv"
} >"$folder/filters_relief.csv"
# These are hundreds of times slower than the others: one round.
position=elliptical,elliptical-visible:form=position,elliptical-visible:form=position-area
sweep filters_position filters --scenes bricks,city,hills --size 160x120 --threads 1 --rounds 1 --filters $position \
    --pixel-models gaussian
# NAME PROGRAM...: compares with other programs, if those are installed.
beside() {
    local file=$folder/$1.csv
    shift
    [ ! -e "$file" ] && [ -x "$1" ] || return 0
    "$@" -o "$file" >"${file%.csv}.txt"
}
beside peers "$bin/relief_peers" --rounds 7
beside filter_peers "$bin/relief_filter_peers"
beside distance_peers "$bin/relief_distance_peers" --rounds 7
beside frames "$bin/relief_frames" 3
# Compares the advice with full tables. It uses processor time and counts, so other processes on the machine matter
# little.
advice() {
    printf '~~~\n'
    local form map
    for form in simd scalar; do
        printf 'form %s\n' $form
        "$bin/relief" recommend --check --form $form --threads 1 --no-filter -q
        for map in datasets/*/height.{png,jpg}; do
            [ -e "$map" ] || continue
            "$bin/relief" recommend --check --form $form --threads 1 --no-filter -q --height "$map" | sed '1d;/^regret/d'
        done
    done
    printf '~~~\n'
}
printed recommend advice
if command -v mpirun >/dev/null && [ -x /usr/bin/time ]; then printed ranks tests/benchmarks/ranks.sh "${2:-build}"; fi
printed sizes tests/benchmarks/sizes.py --build "${2:-build}"
if [ -x "$bin/relief_changes" ]; then printed changes "$bin/relief_changes"; fi
printed steps "$bin/relief_claims" steps
printed wrong "$bin/relief_claims" --rays 100000 wrong
printed gain "$bin/relief_claims" --rays 100000 gain
printed cost "$bin/relief_claims" --rays 100000 cost
printed claims "$bin/relief" claims --measure --json -q
# The table shipped with the program: it becomes part of the next build.
{ printf 'R"json('; cat "$folder/claims.md"; printf ')json"\n'; } >algorithms/measuring/bench/claims_shipped.inc
"$bin/relief_claims" tables tests/benchmarks/RESULTS.md "$folder"
