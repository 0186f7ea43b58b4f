#!/usr/bin/env bash
# Installs, moves the installed tree, and uses it there: headers, library, CMake and pkg-config packages, programs, data
# sets, lessons, manual pages, completion.
#   install_test.sh CMAKE BUILD SOURCES [options of cmake for tests/example]
set -euo pipefail
cmake=$1 build=$2 sources=$3
shift 3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1"; exit 1; }
# A program built without CMake needs the compiler flags of the library, too.
flags=
for option in "$@"; do
    case $option in
        -DCMAKE_CXX_FLAGS=*) flags=${option#*=} flags=${flags//;/ } ;;
        -DCMAKE_CXX_COMPILER=*) CXX=${option#*=} ;;
    esac
done

"$cmake" --install "$build" --prefix "$folder/here" >"$folder/log" || { cat "$folder/log"; exit 1; }
prefix="$folder/moved to there"
mv "$folder/here" "$prefix"
if grep -rF -e "$sources" -e "$build" -e "$folder" "$prefix"/include "$prefix"/lib*/cmake; then
    fail "the package names a place on this machine"
fi
if find "$prefix/include" -name '*-inl.h' | grep .; then fail "private headers are installed"; fi

# An external program finds the package in its new place. Then all headers in one source, in two orders.
project=$folder/project
cp -r "$sources/tests/example" "$project"
(cd "$prefix/include/relief" && find . -name '*.h' | sort | sed 's|^\./|#include <relief/|; s|$|>|') >"$project/all_headers.cpp"
tac "$project/all_headers.cpp" >"$project/all_headers_reversed.cpp"
echo 'target_sources(example PRIVATE all_headers.cpp all_headers_reversed.cpp)' >>"$project/CMakeLists.txt"
"$cmake" -S "$project" -B "$project/build" -DCMAKE_PREFIX_PATH="$prefix" "$@" >"$folder/log" || { cat "$folder/log"; exit 1; }
grep -qF "relief_DIR:PATH=$prefix" "$project/build/CMakeCache.txt" || fail "another relief was found"
"$cmake" --build "$project/build" -j2 >"$folder/log" || { cat "$folder/log"; exit 1; }
"$project/build/example" | grep '^hit at texel'

# The same program, built without CMake.
if command -v pkg-config >/dev/null; then
    pc=$(find "$prefix" -name relief.pc)
    export PKG_CONFIG_PATH=${pc%/*}
    # Spaces in the folder's name are escaped.
    eval "${CXX:-g++} -std=c++20 $flags '$project/main.cpp' $(pkg-config --cflags --libs relief) -o '$folder/plain'"
    "$folder/plain" | grep '^hit at texel'
fi

# In a fresh checkout app/run explains itself without installing or building anything.
mkdir -p "$folder/fresh/app"
cp "$sources/app/run" "$sources/app/setup.sh" "$folder/fresh/app"
"$folder/fresh/app/run" --help > "$folder/help"
grep -q '^Usage: app/run' "$folder/help" || fail "app/run --help explains nothing"
[ "$(ls "$folder/fresh")" = app ] || fail "app/run --help makes $(ls "$folder/fresh")"

[ -s "$prefix/share/doc/reliefscope/lesson.schema.json" ] || fail "the schema of lessons is not installed"
[ -s "$prefix/share/doc/reliefscope/scenario.schema.json" ] || fail "the schema of scenarios is not installed"

[ -s "$prefix/share/reliefscope/recorder/relief_recorder.h" ] || fail "the recorder is not installed"

# The programs run without access to the checkout's folders. Neither loads OpenImageIO or its dependencies at start.
cd "$folder"
share=$prefix/share
relief=$prefix/bin/relief
if ldd "$relief" | grep -i openimageio; then fail "OpenImageIO is loaded at every start"; fi
"$relief" render -q --height "$share/reliefscope/datasets/gray_rocks/height.png" --size 60x40 -o rocks.png
[ -s rocks.png ]
# Shipped files are found relative to the program: here the installed ones, not the checkout's.
cp "$share/reliefscope/datasets/brick_tiles037/height.jpg" "$share/reliefscope/datasets/brick_tiles037/moved.jpg"
"$relief" info datasets/brick_tiles037/moved.jpg | grep -F moved.jpg
"$relief" render -q lessons/missed_spike.json --size 60x40 -o lesson.png
[ -s lesson.png ]
# Without its plug-in for pictures the program reports that, and everything that needs no pictures works.
mv "$prefix/lib/reliefscope/relief_pictures.so" .
status=0
"$relief" info rocks.png 2>said || status=$?
if [ "$status" -ne 2 ] || ! grep -q 'relief_pictures.so: cannot be read' said; then fail "$status $(cat said)"; fi
"$relief" list >listed
mv relief_pictures.so "$prefix/lib/reliefscope"

# There is a manual page for each program and command, and groff formats it without warnings.
for command in $("$relief" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/-\1/p') ''; do
    page=$(find "$share/man/man1" -name "relief$command.1*")
    [ -n "$page" ] || fail "relief$command has no manual page"
    ! command -v man >/dev/null || man --warnings -l "$page" >text 2>said || fail "$page: $(cat said)"
    if [ -s said ]; then fail "$page: $(cat said)"; fi
    ! command -v man >/dev/null || grep -q '^EXIT STATUS' text || fail "$page tells no exit status"
done

# becomes EXPECTED WORD...: checks that bash completes the last WORD to EXPECTED.
completions=$share/bash-completion/completions
becomes() {
    local expected=$1
    shift
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    # compopt fails outside an interactive completion; that is expected.
    "_$1" || true
    [ "${COMPREPLY[*]}" = "$expected" ] || fail "$*: completed by ${COMPREPLY[*]}, not $expected"
}
# shellcheck source=/dev/null
. "$completions/relief"
becomes render relief rend
becomes max-pyramid-paper relief render --tracer max-pyramid-
becomes depth,normal relief render --layers depth,nor
becomes refined-sampled relief map refined-
becomes --address relief render --addr
becomes rocks.png relief render --height roc

if [ -e "$prefix/bin/reliefscope" ]; then
    "$prefix/bin/reliefscope" --lesson 301 --check | grep -F '301 holds'
    # Without a file it shows the stone wall, whose pictures it finds relative to its own location.
    export HOME=$folder
    [ -n "$(find "$share/man/man1" -name 'reliefscope.1*')" ] || fail "reliefscope has no manual page"
    # shellcheck source=/dev/null
    . "$completions/reliefscope"
    becomes --screenshot reliefscope --screen
    becomes footprint reliefscope --export foot
    becomes refined-sampled reliefscope --map refined-
    for file in applications/reliefscope.desktop icons/hicolor/scalable/apps/reliefscope.svg; do
        [ -s "$share/$file" ] || fail "$file is not installed"
    done
    ! command -v desktop-file-validate >/dev/null || desktop-file-validate "$share/applications/reliefscope.desktop"
    "$prefix/bin/reliefscope" --export profile -o profile.svg
    [ -s profile.svg ]
    wall="$prefix/share/reliefscope/datasets/stone_wall_bricks102/height.jpg"
    : >"$wall"
    if "$prefix/bin/reliefscope" --export profile -o again.svg 2>said; then fail "it has other pictures than the installed"; fi
    grep -qF "$wall" said || fail "$(cat said)"
fi
