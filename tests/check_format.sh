#!/usr/bin/env bash
# Checks that all C++ sources are formatted as .clang-format says. Exit status 0: they are; 1: they are not (each place
# is named); 77: cannot be checked. Versions of clang-format differ in detail; the one of Debian 12 is required.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"
version=14
tool=$(command -v "clang-format-$version" || command -v clang-format || true)
if [ -z "$tool" ] || [[ "$("$tool" --version)" != *"version $version."* ]]; then
    echo "clang-format $version is not there: the format is not checked"
    exit 77
fi
# Checks tracked files, or all files if this is not a git checkout (an unpacked archive).
mapfile -d '' -t files < <(git ls-files -z -- 'algorithms/*.cpp' 'algorithms/*.h' 'ui/*.cpp' 'ui/*.h' 'app/*.cpp' \
    'app/*.h' 'tests/*.cpp' 'tests/*.h' 2>/dev/null ||
    find algorithms ui app tests \( -name '*.cpp' -o -name '*.h' \) -print0)
present=()
for file in "${files[@]}"; do if [ -f "$file" ]; then present+=("$file"); fi; done
[ "${#present[@]}" -gt 0 ] || { echo "no source files found"; exit 1; }
"$tool" --dry-run -Werror "${present[@]}"
echo "${#present[@]} files are formatted"
