#!/usr/bin/env bash
# Measures maps larger than memory, as a table: for each side, time, memory and disk that `relief make` takes; time and
# memory of the first picture, from opening the file; time of a warm frame read by tiles, and the same in memory where
# the map fits there (up to 16,384 texels a side).
#   tests/benchmarks/large_maps.sh [BUILD [SIDE...]]     default: build 4096 16384 32768
#   RELIEF_MEMORY: bound in MB for reading, default 1500. RELIEF_SCRATCH: folder for the maps; a side of 65,536 takes
#   21 GB. Nothing else should run meanwhile.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
relief=$root/${1:-build}/bin/relief
shift || true
sides=("$@")
[ ${#sides[@]} -gt 0 ] || sides=(4096 16384 32768)
bound=${RELIEF_MEMORY:-1500}
scratch=$(mktemp -d -p "${RELIEF_SCRATCH:-${TMPDIR:-/tmp}}")
trap 'rm -rf "$scratch"' EXIT
frames=8
views=(--camera 'elevation=25,distance=0.02' --size 640x480 --quiet)

# COMMAND...: seconds and megabytes of resident memory at the peak.
measured() {
    /usr/bin/time -o "$scratch/time" -f '%e %M' "$@" >/dev/null
    awk '{ printf "%.2f %d\n", $1, $2 / 1024 }' "$scratch/time"
}
# OPTION...: milliseconds of a frame after the first one, without opening the map and writing the first picture.
warm() {
    local one many
    read -r one _ < <(measured "$relief" render "${views[@]}" "$@" --to azimuth=0.1 --frames 2 -o "$scratch/frames")
    rm -rf "$scratch/frames"
    read -r many _ < <(measured "$relief" render "${views[@]}" "$@" --to azimuth=0.1 --frames $((frames + 2)) \
        -o "$scratch/frames")
    rm -rf "$scratch/frames"
    awk -v one="$one" -v many="$many" -v frames="$frames" 'BEGIN { printf "%.0f\n", 1000 * (many - one) / frames }'
}

printf '| side | make, s | make, MB | file, GB | first picture, s | first picture, MB | frame by tiles, ms | in memory, ms | ratio |\n'
printf '| --: | --: | --: | --: | --: | --: | --: | --: | --: |\n'
for side in "${sides[@]}"; do
    map=$scratch/map.tif
    read -r make makeMemory < <(measured "$relief" make fractal --size "$side" --tiled -o "$map" --quiet)
    size=$(stat -c %s "$map")
    # Out of the system's cache, where it lets us.
    sync "$map"
    dd if="$map" iflag=nocache count=0 status=none
    read -r first firstMemory < <(measured "$relief" render "$map" --memory "$bound" "${views[@]}" -o "$scratch/first.png")
    tiles=$(warm "$map" --memory "$bound")
    whole=- ratio=-
    if [ "$side" -le 16384 ]; then
        whole=$(warm "$map")
        ratio=$(awk -v a="$tiles" -v b="$whole" 'BEGIN { printf "%.2f", a / b }')
    fi
    printf '| %d | %s | %d | %.2f | %s | %d | %s | %s | %s |\n' "$side" "$make" "$makeMemory" \
        "$(awk -v n="$size" 'BEGIN { print n / 1e9 }')" "$first" "$firstMemory" "$tiles" "$whole" "$ratio"
    rm -f "$map" "$scratch/first.png"
done
printf '\n(%s, %s processors, --memory %s)\n' "$(sed -n 's/^model name[^:]*: //p;T;q' /proc/cpuinfo)" "$(nproc)" "$bound"
