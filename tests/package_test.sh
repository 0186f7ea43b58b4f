#!/usr/bin/env bash
# Installs the Debian package in a bare Debian 12 and starts the programs there. To be run by hand: needs root,
# debootstrap, and Debian's packages from a mirror; takes some minutes and 3 GB in ROOT (default: a new folder below
# /tmp, removed afterwards; a ROOT that is given is kept).
#   cmake --build build && (cd build && cpack -G DEB) && tests/package_test.sh build/reliefscope_*.deb [ROOT [MIRROR]]
set -euo pipefail
package=$(realpath "$1")
root=${2:-$(mktemp -d)}
mirror=${3:-http://deb.debian.org/debian}
leave() {
    ! mountpoint -q "$root/proc" || umount "$root/proc"
    [ -n "$kept" ] || rm -rf --one-file-system "$root"
}
kept=${2:-}
trap leave EXIT
fail() { echo "$1"; exit 1; }

[ -x "$root/usr/bin/apt-get" ] || debootstrap --variant=minbase bookworm "$root" "$mirror"
# The programs determine their own location through /proc.
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
cp "$package" "$root/tmp/reliefscope.deb"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get -qq update
inside apt-get -y -qq install --no-install-recommends /tmp/reliefscope.deb

inside relief --version
inside sh -c 'cd /tmp && relief make bricks -o bricks.png && relief render --height bricks.png -o wall.png'
inside relief info datasets/gray_rocks/height.png
inside sh -c 'cd /tmp && relief render -q lessons/missed_spike.json -o lesson.png'
inside reliefscope --version
# Exporting a figure needs no display. It shows the data set with which the window opens.
inside reliefscope --export profile -o /tmp/profile.svg
status=0
inside reliefscope --check-display || status=$?
[ "$status" -eq 2 ] || fail "without a display reliefscope ends with status $status"
inside apt-get -y -qq install --no-install-recommends xvfb xauth
inside xvfb-run -a -s "-screen 0 1600x1000x24" reliefscope --anew --screenshot /tmp/window.png --size 1280x720
for file in bricks wall lesson window; do [ -s "$root/tmp/$file.png" ] || fail "$file.png was not written"; done
[ -s "$root/tmp/profile.svg" ] || fail "profile.svg was not written"
inside apt-get -y -qq purge reliefscope
if find "$root/usr" -name '*relief*' | grep .; then fail "these files stay when the package is removed"; fi
echo "the package installs, starts and goes"
