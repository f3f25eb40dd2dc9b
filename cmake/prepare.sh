# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034
# Sourced by tests/run and experiments/run: installs the packages that are missing and builds what
# has changed. Debian 12 and Ubuntu 24.04 have every package under these names, but for those with a
# question mark, which silt can do without.

build_packages=(
  build-essential cmake ninja-build
  libeigen3-dev libtbb-dev libxsimd-dev                           # core, tracker
  libopencv-dev libdlib-dev libblas-dev liblapack-dev             # image files, sparse features
  libceres-dev                                                    # the graph over keyframes
  libembree-dev libassimp-dev libarchive-dev libtomlplusplus-dev  # sim
  libcli11-dev libspdlog-dev nlohmann-json3-dev                   # experiments
  "libopen3d-dev?"                                                # meshes of maps
)
run_packages=(
  sweethome3d-furniture       # the models of the scenes
  python3 python3-matplotlib  # the figures of the reports
)
test_packages=(
  libgtest-dev libgmock-dev assimp-testmodels
  qemu-user  # plays processors without AVX
)

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$root/build/release

fail() {
  echo "silt: $*" >&2
  exit 1
}

# install_packages PACKAGE…: those of them that are not yet there, with apt; PACKAGE? if there is one.
install_packages() {
  local missing=() package as_root=()
  if ! command -v apt-get >/dev/null; then
    echo "silt: no apt here; trusting that what these packages hold is installed: $*" >&2
    return
  fi
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${Status}' "${package%\?}" 2>/dev/null) == *"ok installed" ]] ||
      missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  [[ ${missing[*]} != *\? || ${#missing[@]} -gt 1 ]] || apt-cache show "${missing[0]%\?}" \
    >/dev/null 2>&1 || return 0 # all that is missing is nowhere to be had
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "neither root nor sudo; have root run: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  local log=$root/build/apt.log
  mkdir -p "${log%/*}"
  echo "silt: installing ${missing[*]} (log: $log)"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get -y -q -o DPkg::Lock::Timeout=600)
  # A source that cannot be refreshed matters only if the installation fails for it.
  "${apt[@]}" update </dev/null >"$log" 2>&1 || true
  local wanted=()
  for package in "${missing[@]}"; do
    if [[ $package == *\? ]] && ! apt-cache show "${package%\?}" >/dev/null 2>&1; then
      echo "silt: no package ${package%\?} here; going on without it"
    else
      wanted+=("${package%\?}")
    fi
  done
  ((${#wanted[@]})) || return 0
  "${apt[@]}" install --no-install-recommends "${wanted[@]}" </dev/null >>"$log" 2>&1 ||
    fail "apt-get failed: $(grep -m1 '^E:' "$log" || tail -n1 "$log")"
}

# As many compilers as processors, but no more than one per 2 GiB of memory.
job_count() {
  local by_memory processors
  by_memory=$(awk '/MemTotal/ {print int($2 / 2097152)}' /proc/meminfo)
  processors=$(nproc)
  echo $((by_memory < 1 ? 1 : by_memory < processors ? by_memory : processors))
}

# build_silt on|off TARGET…: configures where needed, with the tests or not, and builds.
build_silt() {
  local tests=$1
  shift
  local cache=$build/CMakeCache.txt
  mkdir -p "$build"
  exec 9>"$build/.lock"
  flock 9 # a second run in the same clone waits for the first
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "$cache" "$build/CMakeFiles" "$build/build.ninja" # the clone was moved
  fi
  if [[ ! -f $build/build.ninja || $root/CMakePresets.json -nt $build/build.ninja ]] ||
    { [[ $tests == on ]] && ! grep -qx 'SILT_BUILD_TESTS:BOOL=ON' "$cache"; }; then
    (cd "$root" && cmake --preset release -DSILT_BUILD_TESTS="${tests^^}") ||
      fail "cmake could not configure the build"
  fi
  cmake --build "$build" -j "$(job_count)" --target "$@" || fail "the build failed"
  exec 9>&-
}
