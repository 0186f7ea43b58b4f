#!/usr/bin/env bash
# Installs, moves what was installed, and uses it there: headers, library, CMake package, programs.
#   install_test.sh CMAKE BUILD SOURCES [options of cmake for tests/example]
set -euo pipefail
cmake=$1 build=$2 sources=$3
shift 3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1"; exit 1; }

"$cmake" --install "$build" --prefix "$folder/here" >"$folder/log" || { cat "$folder/log"; exit 1; }
prefix="$folder/moved to there"
mv "$folder/here" "$prefix"
if grep -rF -e "$sources" -e "$build" -e "$folder" "$prefix"/include "$prefix"/lib*/cmake; then
    fail "the package names a place on this machine"
fi
if find "$prefix/include" -name '*-inl.h' | grep .; then fail "private headers are installed"; fi

# A program of somebody else's, with the package found in its new place; and all headers in one source, in two orders.
project=$folder/project
cp -r "$sources/tests/example" "$project"
(cd "$prefix/include/relief" && find . -name '*.h' | sort | sed 's|^\./|#include <relief/|; s|$|>|') >"$project/all_headers.cpp"
tac "$project/all_headers.cpp" >"$project/all_headers_reversed.cpp"
echo 'target_sources(example PRIVATE all_headers.cpp all_headers_reversed.cpp)' >>"$project/CMakeLists.txt"
"$cmake" -S "$project" -B "$project/build" -DCMAKE_PREFIX_PATH="$prefix" "$@" >"$folder/log" || { cat "$folder/log"; exit 1; }
grep -qF "relief_DIR:PATH=$prefix" "$project/build/CMakeCache.txt" || fail "another relief was found"
"$cmake" --build "$project/build" -j2 >"$folder/log" || { cat "$folder/log"; exit 1; }
"$project/build/example" | grep '^hit at texel'

# The programs, with none of the checkout's folders named.
cd "$folder"
"$prefix/bin/relief" render -q --height "$prefix/share/reliefscope/datasets/gray_rocks/height.png" --size 60x40 -o rocks.png
[ -s rocks.png ]
if [ -e "$prefix/bin/reliefscope" ]; then
    # Without a file it shows the stone wall, whose pictures it finds from its own place.
    export HOME=$folder
    "$prefix/bin/reliefscope" --export profile -o profile.svg
    [ -s profile.svg ]
    wall="$prefix/share/reliefscope/datasets/stone_wall_bricks102/height.jpg"
    : >"$wall"
    if "$prefix/bin/reliefscope" --export profile -o again.svg 2>said; then fail "it has other pictures than the installed"; fi
    grep -qF "$wall" said || fail "$(cat said)"
fi
