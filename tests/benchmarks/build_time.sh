#!/usr/bin/env bash
# Measures how long a newcomer waits: builds a clone of this checkout's last commit, without compiler cache and display.
#   tests/benchmarks/build_time.sh [FOLDER]     the clone is made in FOLDER (default: a temporary one, removed afterwards)
# Prints lines of the table in build_time.md: seconds of app/run until its pictures are made and until it ends, of
# tests/run after that, and of building the program again after editing one source. Missing packages are installed, and
# that time is included. Stop everything else first.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
folder=${1:-}
if [ -z "$folder" ]; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
fi
export CCACHE_DISABLE=1
unset DISPLAY WAYLAND_DISPLAY
git clone -q "$root" "$folder/reliefscope"
cd "$folder/reliefscope"

# timed NAME COMMAND...: prints a line of the table; the command's output goes to FOLDER/log.
timed() {
    local name=$1 begin=$SECONDS status=0
    shift
    "$@" >>"$folder/log" 2>&1 </dev/null || status=$?
    printf '| %s | %d | %d |\n' "$name" $((SECONDS - begin)) "$status"
}

printf 'commit %s, %s, %s processors, %s, load before %s, %s packages installed before\n\n' \
    "$(git rev-parse --short=12 HEAD)" "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)" \
    "$(date -I)" "$(cut -d ' ' -f 1 /proc/loadavg)" "$(dpkg-query -f '.\n' -W | wc -l)"
printf '| what | seconds | status |\n| --- | --: | --: |\n'
begin=$(date +%s)
timed "app/run to its end, the window's program built" app/run
printf '| app/run to its pictures | %d | |\n' $(($(find build/figures -type f -printf '%Ts\n' | sort -n | tail -n 1) - begin))
timed "tests/run after it" tests/run
grep -oE '^([0-9]+% tests passed.*|Total Test time.*)' "$folder/log" | tail -n 2 >&2 || true
for source in ui/panes/profile/profile_view.cpp algorithms/relief/tracers/tracers.cpp \
    algorithms/relief/simd/cone_lanes_bilinear.cpp; do
    [ -f "$source" ] || continue
    touch "$source"
    timed "program after an edit of \`$source\`" cmake --build build --target relief_cli reliefscope
done
