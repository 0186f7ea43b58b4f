# shellcheck shell=bash
# Functions shared by app/run and tests/run: install missing packages, configure, build. Sourced, not executed.
# All messages go to stderr; a step that failed is reported in one line that begins with "reliefscope:".
# shellcheck disable=SC2034  # the lists are used by the scripts that source this file

reliefRoot=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

# Packages of Debian 12. The first group is mandatory; if others are missing, the program or tests that need them are
# not built.
reliefPackagesBuild=(g++ cmake ninja-build libopenimageio-dev openimageio-tools libglm-dev libcli11-dev
    nlohmann-json3-dev libtbb-dev libhwy-dev ccache glslang-tools spirv-cross
    libboost-dev)
reliefPackagesWindow=(libvtk9-dev libvtk9-qt-dev libqt5svg5-dev qttools5-dev qttools5-dev-tools
    qttranslations5-l10n libx11-dev fonts-dejavu-core)
reliefPackagesTest=(libgtest-dev libbenchmark-dev xvfb xauth locales clang-format parallel pkg-config python3
    python3-jsonschema python3-numpy doxygen libegl-dev libgl-dev libegl1 libgl1-mesa-dri spirv-tools)

reliefSay() { printf 'reliefscope: %s\n' "$*" >&2; }
reliefDie() {
    reliefSay "$*"
    exit 1
}

# Runs a command silently; shows the last lines of its output if it fails.
reliefQuietly() {
    local log status=0
    log=$(mktemp)
    "$@" >"$log" 2>&1 </dev/null || status=$?
    [ "$status" -eq 0 ] || tail -n 25 "$log" >&2
    rm -f "$log"
    return "$status"
}

# Prints the packages that are not installed.
reliefMissing() {
    local installed package
    # dpkg-query fails if any package is unknown to it; its output about the others is still valid.
    installed=$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' "$@" 2>/dev/null || true)
    for package in "$@"; do
        grep -Fxq -- "ii $package" <<<"$installed" || printf '%s\n' "$package"
    done
}

# Prints the prefix that runs a command as root ("env", or "sudo env"); fails if there is no way to do so.
reliefAsRoot() {
    if [ "$(id -u)" -eq 0 ]; then
        echo "env"
    elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
        echo "sudo env"
    else
        return 1
    fi
}

reliefApt() {
    local asRoot
    read -ra asRoot <<<"$(reliefAsRoot)"
    reliefQuietly "${asRoot[@]}" DEBIAN_FRONTEND=noninteractive apt-get -y -o DPkg::Lock::Timeout=120 "$@"
}

# Installs packages. If that fails (outdated lists, another apt running), updates the lists and tries again.
reliefInstall() {
    if [ "$(reliefAsRoot)" = "sudo env" ] && ! sudo -n true 2>/dev/null; then sudo -v || return 1; fi
    local attempt
    for attempt in 1 2; do
        [ "$attempt" -eq 1 ] || { reliefSay "that failed, once more"; sleep 5; }
        reliefApt update || true
        if reliefApt install --no-install-recommends "$@"; then return 0; fi
    done
    reliefSay "that failed again; one by one, to get what there is"
    local package status=0
    for package in "$@"; do reliefApt install --no-install-recommends "$package" 2>/dev/null || status=1; done
    return "$status"
}

reliefHasApt() {
    local ID="" ID_LIKE=""
    # shellcheck source=/dev/null
    [ ! -r /etc/os-release ] || . /etc/os-release
    case " $ID $ID_LIKE " in *" debian "* | *" ubuntu "*) command -v apt-get >/dev/null ;; *) return 1 ;; esac
}

# reliefNeed PACKAGE...: installs the packages that are missing. Exits with a one-line message only if not even the
# build tools are available; other missing packages are detected and named by CMake.
reliefNeed() {
    local missing=()
    if ! reliefHasApt; then
        reliefHasTools ||
            reliefDie "not a Debian system; please install cmake, ninja, a C++20 compiler, OpenImageIO, GLM, oneTBB," \
                "nlohmann-json, CLI11, Highway, Boost, GoogleTest, and for the window VTK 9 with Qt 5"
        return 0
    fi
    mapfile -t missing < <(reliefMissing "$@")
    [ "${#missing[@]}" -gt 0 ] || return 0
    if ! reliefAsRoot >/dev/null; then
        reliefSay "neither root nor sudo; please install: ${missing[*]}"
    else
        reliefSay "installing ${#missing[@]} packages and what they need: ${missing[*]}"
        reliefInstall "${missing[@]}" ||
            reliefSay "could not be installed: $(reliefMissing "${missing[@]}" | paste -sd ' ')"
    fi
    reliefHasTools || exit 1
}

reliefHasTools() {
    command -v cmake >/dev/null && command -v ninja >/dev/null && { command -v c++ || command -v g++; } >/dev/null
}

# Makes the locale with which the tests check for decimal commas; tests that need it are skipped if it cannot be made.
reliefNeedLocale() {
    local asRoot
    if locale -a 2>/dev/null | grep -qi '^uk_UA\.utf-\?8$'; then return 0; fi
    if ! command -v localedef >/dev/null || ! reliefAsRoot >/dev/null; then return 0; fi
    read -ra asRoot <<<"$(reliefAsRoot)"
    reliefSay "making the locale uk_UA.UTF-8"
    reliefQuietly "${asRoot[@]}" localedef -i uk_UA -f UTF-8 uk_UA.UTF-8 || reliefSay "could not be made; going on"
}

# reliefConfigure FOLDER OPTION...: runs CMake for Ninja. A folder that was configured elsewhere (a copied or renamed
# checkout) or for another generator is configured from scratch.
reliefConfigure() {
    local folder=$1 cache=$1/CMakeCache.txt line
    shift
    if [ -f "$cache" ]; then
        for line in "CMAKE_HOME_DIRECTORY:INTERNAL=$reliefRoot" "CMAKE_CACHEFILE_DIR:INTERNAL=$folder" \
            "CMAKE_GENERATOR:INTERNAL=Ninja"; do
            grep -Fxq -- "$line" "$cache" || { rm -rf "$cache" "$folder/CMakeFiles"; break; }
        done
    fi
    reliefQuietly cmake -G Ninja -S "$reliefRoot" -B "$folder" "$@" || reliefDie "could not be configured (see above)"
}

# reliefBuild FOLDER TARGET...: builds the targets, or everything.
reliefBuild() {
    local folder=$1
    shift
    cmake --build "$folder" ${1:+--target "$@"} >&2 </dev/null || reliefDie "could not be built (see above)"
}

# reliefHasTarget FOLDER TARGET: succeeds if the configured folder has the target.
reliefHasTarget() { grep -q -- "^build $2: phony " "$1/build.ninja"; }
