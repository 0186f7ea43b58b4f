#!/usr/bin/env bash
# Tables of a README made of small sweeps: the numbers are the files' own.   readme_test.sh RELIEF RELIEF_CLAIMS
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1"; cat "$folder/README.md"; exit 1; }

"$1" bench rows --widths 16384 --elevations 25 --precisions float --variants direct,streams:streams=4,fill \
    --pixels 20000 --rounds 2 --threads 1 -o "$folder/rows.csv"
"$1" bench filters --scenes checker --filters bilinear,elliptical:weights=uniform --elevations 60,25 --size 24x16 \
    --samples 4 --rounds 1 --threads 1 -o "$folder/filters_checker.csv"
printf 'steps as printed\n' >"$folder/steps.md"
cat >"$folder/README.md" <<'END'
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
"$2" readme "$folder/README.md" "$folder"
for words in before between after 'nobody measured this' 'steps as printed' '| `direct` | 8 / 8 / 2 | 8.00 / 8.00 / 2.00 |' \
    '| `streams`, 4 | 0 / 4 / 2 |' '| `bilinear` |' '| `elliptical:weights=uniform` |'; do
    grep -qF "$words" "$folder/README.md" || fail "missing: $words"
done
if grep -q 'old' "$folder/README.md"; then fail "an old table is left"; fi
# The error of the file's second row (streams), to two digits.
error=$(sed -n 3p "$folder/rows.csv" | cut -d, -f14 | xargs printf '%.1e' | sed 's/e.*//')
grep -F '`streams`' "$folder/README.md" | sed 's/[0.]//g' | grep -qF "${error//./}" || fail "not the file's error: $error"
# Again: nothing changes.
cp "$folder/README.md" "$folder/once"
"$2" readme "$folder/README.md" "$folder"
cmp "$folder/once" "$folder/README.md"
printf 'variant,width\nfill,3\n' >"$folder/rows.csv"
if "$2" readme "$folder/README.md" "$folder" 2>"$folder/said"; then fail "a file without the row was taken"; fi
grep -q 'rows.csv' "$folder/said"
