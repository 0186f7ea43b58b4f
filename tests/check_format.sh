#!/usr/bin/env bash
# Whether all our C++ is formatted as .clang-format says. Exit status 0 yes, 1 no (each place is named), 77 cannot tell.
# Versions of clang-format differ in detail; ours is that of Debian 12, and no other is asked.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"
version=14
tool=$(command -v "clang-format-$version" || command -v clang-format || true)
if [ -z "$tool" ] || [[ "$("$tool" --version)" != *"version $version."* ]]; then
    echo "clang-format $version is not there: the format is not checked"
    exit 77
fi
# Tracked files; all of them where this is no checkout of git (an unpacked archive).
mapfile -d '' -t files < <(git ls-files -z -- 'algorithms/*.cpp' 'algorithms/*.h' 'ui/*.cpp' 'ui/*.h' 'app/*.cpp' \
    'app/*.h' 'tests/*.cpp' 'tests/*.h' 2>/dev/null ||
    find algorithms ui app tests \( -name '*.cpp' -o -name '*.h' \) -print0)
present=()
for file in "${files[@]}"; do if [ -f "$file" ]; then present+=("$file"); fi; done
[ "${#present[@]}" -gt 0 ] || { echo "no source files found"; exit 1; }
"$tool" --dry-run -Werror "${present[@]}"
echo "${#present[@]} files are formatted"
