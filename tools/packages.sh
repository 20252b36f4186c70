# SPDX-License-Identifier: MIT
# Sourced by ./demo and ./check: installs the Debian packages that are missing. Sets nothing but functions.

OMBRAGE_BUILD_PACKAGES="g++ cmake ninja-build pkg-config libegl1 libegl-dev libopengl0 libgl1-mesa-dri libepoxy-dev libglm-dev libassimp-dev \
 libembree-dev libtbb-dev nlohmann-json3-dev libcli11-dev libfmt-dev libstb-dev libopenexr-dev libxxhash-dev libsqlite3-dev libnlopt-dev libgtest-dev"
OMBRAGE_TEST_PACKAGES="chromium python3 ccache locales"

# ombrage_install PACKAGE...: does nothing when all are there; exit 4 when they cannot be installed.
ombrage_install() {
  local missing="" package
  for package in "$@"; do
    if [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" != "install ok installed" ]; then
      missing="$missing $package"
    fi
  done
  [ -n "$missing" ] || return 0
  echo "Packages to install:$missing"
  local as_root=""
  if [ "$(id -u)" != 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      as_root="sudo"
    else
      echo "They need root. Run this, then try again:" >&2
      echo "  sudo apt-get update && sudo apt-get install -y --no-install-recommends$missing" >&2
      exit 4
    fi
  fi
  # shellcheck disable=SC2086
  if ! $as_root apt-get update -qq ||
     ! $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null; then
    echo "apt-get could not install:$missing" >&2
    exit 4
  fi
}

# ombrage_build PRESET [TARGET...]: configures and builds, everything or the targets.
ombrage_build() {
  cmake --preset "$1" >"build-$1.log" 2>&1 || { cat "build-$1.log" >&2; exit 4; }
  rm -f "build-$1.log"
  local preset="$1"
  shift
  cmake --build --preset "$preset" ${1:+--target "$@"}
}
