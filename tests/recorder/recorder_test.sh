#!/usr/bin/env bash
# Records tracers of others over the rays of a view, and checks what `relief diagnose` says of them.
#   recorder_test.sh RELIEF MARCHER RECORDER TESTS
set -euo pipefail
relief=$1 marcher=$2 recorder=$3 tests=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "$1"; exit 1; }

# expect STATUS BEGIN...: the status of the last diagnosis, and how its lines begin.
expect() {
    local status=$1 n=0
    shift
    [ "$(cat status)" = "$status" ] || { cat said; fail "status $(cat status), not $status"; }
    for begin in "$@"; do
        n=$((n + 1))
        [[ "$(sed -n "${n}p" said)" == "$begin"* ]] || { cat said; fail "line $n does not begin with $begin"; }
    done
}
diagnose() {
    local status=0
    "$relief" diagnose map.pgm --relief-depth 0.2 --rays rays.csv "$@" >said || status=$?
    echo "$status" >status
}

"$marcher" make map.pgm
"$relief" export rays map.pgm --relief-depth 0.2 --camera elevation=30 --size 40x30 -o rays.csv

# C++: hits, steps with a column of its own, and both through the commands that read them.
"$marcher" trace map.pgm rays.csv hits.csv steps.csv
diagnose --hits hits.csv --steps steps.csv -o worst.json
expect 1 "stair-steps: "
grep -q '"steps": "steps.csv"' worst.json || fail "the scenario does not name the recorded steps"
head -n 1 steps.csv | grep -q ',kind,gap$' || fail "the column gap is missing"
diagnose --steps steps.csv
expect 1 "stair-steps: "
[ "$(sed -n 2p hits.csv | cut -d , -f 5)" = "$(grep -c '^0,' steps.csv)" ] || fail "the hit counts other steps than the log"
for files in "/dev/full steps.csv" "hits.csv /dev/full"; do
    if "$marcher" trace map.pgm rays.csv $files 2>said; then fail "a full disk is not reported ($files)"; fi
    grep -q '^/dev/full: ' said || { cat said; fail "the message does not name the file"; }
done

# Python, with and without its fault.
python=
# Debian's package is for /usr/bin/python3.
for one in python3 /usr/bin/python3; do
    if "$one" -c 'import numpy' 2>/dev/null; then python=$one; fi
done
if [ -n "$python" ]; then
    export RELIEF_RECORDER=$recorder PYTHONDONTWRITEBYTECODE=1
    "$python" "$tests/numpy_tracer.py" map.pgm rays.csv hits.csv
    diagnose --hits hits.csv
    expect 1 "y-flipped: "
    "$python" "$tests/numpy_tracer.py" map.pgm rays.csv hits.csv --correct
    diagnose --hits hits.csv
    expect 0 "no fault: "
else
    echo "numpy is not there: the tracer in Python is left out"
fi

# Shaders: the include is valid in both languages, and the bytes of its buffer become files.
if command -v glslangValidator >/dev/null; then
    {
        printf '#version 450\nlayout(local_size_x = 1) in;\n'
        cat "$recorder/relief_recorder.glsl"
        printf 'void main() { reliefBegin(0u); reliefStep(0.0, 0.5, 0.25); reliefHit(0.5); reliefMiss(); reliefLimit(); }\n'
    } >test.comp
    glslangValidator -V test.comp -o test.spv >log || { cat log; fail "the include is not valid GLSL"; }
    {
        printf '#define RELIEF_HLSL\n'
        cat "$recorder/relief_recorder.glsl"
        printf '[numthreads(1, 1, 1)] void main() { reliefBegin(0); reliefStep(0.0, 0.5, 0.25); reliefHit(0.5); reliefMiss(); '
        printf 'reliefLimit(); }\n'
    } >test.hlsl
    glslangValidator -D -V -S comp -e main test.hlsl -o test.spv >log || { cat log; fail "the include is not valid HLSL"; }
fi
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$recorder python3 - <<'PYTHON'
import struct
from relief_recorder import Recorder, write_buffer
rays = [(1.5, 2.5, 4.0, 0.0), (3.5, 2.5, 0.0, 0.0)]
# Two answers, then the steps of ray 0: one that moves on, and the hit.
records = [(1.0, 0.5, 2.0, 0.0), (2.0, 0.0, 1.0, 0.0), (0.0, 0.5, 0.625, 0.0), (0.5, 0.5, 0.625, 1.0)]
data = struct.pack("<4i", 8, 2, 0, 2) + b"".join(struct.pack("<4f", *record) for record in records) + bytes(16 * 4)
write_buffer(data, rays, "hits.csv", "steps.csv", 96, 64)

def refused(header, second, rays, part):
    records = [(1.0, 0.5, 2.0, 0.0), second]
    data = struct.pack("<4i", *header) + b"".join(struct.pack("<4f", *record) for record in records)
    try:
        write_buffer(data, rays, "refused.csv", "steps.csv", 96, 64)
    except ValueError as error:
        assert part in str(error), error
    else:
        raise AssertionError("not refused: " + part)

miss = (2.0, 0.0, 1.0, 0.0)
refused((2, 0, -1, 2), (0.0, 0.0, 0.0, 0.0), rays, "ray 1 has no answer")
refused((2, 0, -1, 2), miss, rays[:1], "for 2 rays, not for 1")
refused((2, 3, 0, 2), miss, rays, "2 records, but the answers and steps need 5")
refused((2, 0, -1, 3), miss, rays + rays[:1], "2 records, but the answers and steps need 3")

class Number(float):  # NumPy's, which repr() writes with their type
    def __repr__(self):
        return f"np.float64({float(self)})"
    def __mul__(self, other):
        return Number(float(self) * other)
    def __radd__(self, other):
        return Number(other + float(self))

with Recorder("numbers.csv", None, 96, 64) as recorder:
    recorder.ray(rays[0])
    recorder.hit(Number(0.5))
with open("numbers.csv") as file:
    assert file.read().splitlines()[1] == "hit,0.5,3.5,2.5,1"
PYTHON
[ "$(sed -n 2p hits.csv)" = "hit,0.5,3.5,2.5,2" ] || { cat hits.csv; fail "the hit of the buffer is wrong"; }
[ "$(sed -n 3p hits.csv)" = "miss,,,,1" ] || { cat hits.csv; fail "the miss of the buffer is wrong"; }
[ "$(sed -n 3p steps.csv)" = "0,2,search,0,3,2,0,0.5,0.5,0.5,0.5,0.625,hit,0.5,point" ] || { cat steps.csv; fail "the steps of the buffer are wrong"; }
echo "the recorders write what the doctor reads"
