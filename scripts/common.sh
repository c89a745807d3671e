# shellcheck shell=bash disable=SC2034
# What the scripts share; they source it. It changes to the top folder of the project.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# are_installed PACKAGE...: whether all of the Debian packages are there.
are_installed() {
  local package
  for package in "$@"; do
    [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] || return 1
  done
}

# change_packages ARGUMENTS...: calls apt-get, and waits for another package manager, at most ten minutes. apt-get itself
# waits for the lock of dpkg, but not for that of the lists.
change_packages() {
  local as_root=() message end=$((SECONDS + 600))
  [[ $EUID -eq 0 ]] || as_root=(sudo)
  until message=$("${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
    apt-get --quiet=2 -o DPkg::Lock::Timeout=600 "$@" 2>&1 >/dev/null); do
    if [[ $message != *"Could not get lock"* || $SECONDS -ge $end ]]; then
      echo "$message" >&2
      return 1
    fi
    sleep 2
  done
}

# install_packages PACKAGE...: installs those of the Debian packages that are missing; no network if all are there.
install_packages() {
  local package missing=()
  for package in "$@"; do
    are_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0
  echo "Installing ${missing[*]}"
  change_packages update
  change_packages install --yes --no-install-recommends "${missing[@]}"
}

# number_of_jobs: one per core, as long as each has the memory that compiling with CGAL takes.
number_of_jobs() {
  local cores memory_in_kb jobs
  cores=$(nproc)
  memory_in_kb=$(awk '/^MemAvailable/ { print $2 }' /proc/meminfo)
  jobs=$((memory_in_kb / 3500000))
  echo $((jobs < 1 ? 1 : jobs < cores ? jobs : cores))
}

# Sources of one program are compiled several at a time, so that the templates that they share are compiled once.
together=(-DCMAKE_UNITY_BUILD=ON)

packages_of_program=(g++ cmake make libcgal-dev libboost-dev libboost-test-dev libeigen3-dev libtbb-dev libcli11-dev
                     nlohmann-json3-dev libmeshoptimizer-dev zlib1g-dev libjs-three)
# What only some tests read results with, or check the scripts of the page with; they are skipped without.
packages_of_readers=(chromium chromium-driver python3-selenium python3-vtk9 python3-meshio python3-networkx python3-jsonschema nodejs eslint graphviz groff-base zsh fish)
# With these, scripts/test builds and tests the program for ranks of MPI as well.
packages_of_mpi=(libboost-mpi-dev libopenmpi-dev openmpi-bin)
has_mpi() { if are_installed "${packages_of_mpi[@]}"; then echo ON; else echo OFF; fi; }
# With these, scripts/test builds and tests the Python package as well, and scripts/demo --python shows it.
packages_of_python=(pybind11-dev python3-pybind11 python3-numpy python3-pytest python3-dev)
# With these, scripts/check compiles the headers with another standard library.
packages_of_libcxx=(clang libc++-dev libc++abi-dev)
# scripts/web compiles the program for web browsers with these.
packages_of_web=(emscripten node-acorn libfast-float-dev python3 bzip2 xz-utils)
packages_of_tests=("${packages_of_program[@]}" doxygen libgudhi-dev python3 "${packages_of_python[@]}")
