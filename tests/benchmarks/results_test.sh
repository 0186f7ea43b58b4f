#!/usr/bin/env bash
# Inserts the tables of small sweeps into a document and compares their numbers with the files.
#   results_test.sh RELIEF RELIEF_CLAIMS
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1"; cat "$folder/document.md"; exit 1; }

"$1" bench rows --widths 16384 --elevations 25 --precisions float --variants direct,streams:streams=4,fill \
    --pixels 20000 --rounds 2 --threads 1 -o "$folder/rows.csv"
"$1" bench filters --scenes checker --filters bilinear,elliptical:weights=uniform --elevations 60,25 --size 24x16 \
    --samples 4 --rounds 1 --threads 1 -o "$folder/filters_checker.csv"
printf 'steps as printed\n' >"$folder/steps.md"
cat >"$folder/document.md" <<'END'
before
<!-- table rows -->
old rows
<!-- end -->
between
<!-- table filters_checker -->
<!-- end -->
<!-- table steps -->
old steps
<!-- end -->
<!-- table cost -->
nobody measured this
<!-- end -->
after
END
"$2" tables "$folder/document.md" "$folder"
for words in before between after 'nobody measured this' 'steps as printed' '| `direct` | 8 / 8 / 2 | 8.00 / 8.00 / 2.00 |' \
    '| `streams`, 4 | 0 / 4 / 2 |' '| `bilinear` |' '| `elliptical:weights=uniform` |' "$(date -r "$folder/rows.csv" +%Y-%m-%d))"; do
    grep -qF "$words" "$folder/document.md" || fail "missing: $words"
done
if grep -q 'old' "$folder/document.md"; then fail "an old table is left"; fi
# The error of the file's second row (streams), to two digits.
error=$(sed -n 3p "$folder/rows.csv" | cut -d, -f14 | xargs printf '%.1e' | sed 's/e.*//')
grep -F '`streams`' "$folder/document.md" | sed 's/[0.]//g' | grep -qF "${error//./}" || fail "not the file's error: $error"
# A second run changes nothing.
cp "$folder/document.md" "$folder/once"
"$2" tables "$folder/document.md" "$folder"
cmp "$folder/once" "$folder/document.md"
printf 'variant,width\nfill,3\n' >"$folder/rows.csv"
if "$2" tables "$folder/document.md" "$folder" 2>"$folder/said"; then fail "a file without the row was taken"; fi
grep -q 'rows.csv' "$folder/said"
