# Sourced by ./bench and ./test: everything from a fresh Debian 12 to a built program.
# setup_packages installs what is missing, setup_build configures and builds.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build"

# What nothing else in the list depends on. ccache and mold are used where present.
packages=(
  cmake g++ ninja-build pkg-config
  glslang-dev glslang-tools libspirv-cross-c-shared-dev
  libvulkan-dev libvulkan-volk-dev mesa-vulkan-drivers vulkan-validationlayers
  libegl-dev libgl1-mesa-dri libosmesa6-dev
  libbenchmark-dev libcli11-dev libfmt-dev libglm-dev libgtest-dev
  libembree-dev libtbb-dev libboost-dev libre2-dev
  libdraco-dev libmeshoptimizer-dev libwebp-dev # compressed glTF files
  libstb-dev libtinyexr-dev libtinygltf-dev libtomlplusplus-dev nlohmann-json3-dev
  libjs-vega # draws the report's plots
)
# The tests alone: Google Benchmark's compare.py, and a browser for the report's page.
test_packages=(zlib1g-dev libbenchmark-tools python3-scipy chromium chromium-driver python3-selenium)

say() { printf '%s\n' "$*" >&2; }

setup_packages() { # $1: yes or no, may install; more: packages beside the common ones
  local stamp="$build/.packages-ok" want packages=("${packages[@]}" "${@:2}")
  want=$(printf '%s\n' "${packages[@]}")
  [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$want" ] && return 0
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    [ -f "$build/build.ninja" ] && return 0
    say "This is no Debian system. ShadowBench needs what these Debian 12 packages hold:"
    printf '  %s\n' "${packages[@]}" >&2
    return 0
  fi
  local missing=() p
  for p in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$p" 2>/dev/null)" = installed ] || missing+=("$p")
  done
  if [ ${#missing[@]} -gt 0 ]; then
    if [ "$1" = no ]; then
      say "Missing Debian packages (apt-get install ${missing[*]}):"
      printf '  %s\n' "${missing[@]}" >&2
      return 2
    fi
    local sudo=()
    if [ "$(id -u)" != 0 ]; then
      command -v sudo >/dev/null || { say "Not root and no sudo. Missing packages: ${missing[*]}"; return 2; }
      sudo=(sudo)
    fi
    say "Installing ${missing[*]}"
    "${sudo[@]}" apt-get update -qq >&2 &&
      "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
        "${missing[@]}" >&2 || { say "apt-get failed; missing packages: ${missing[*]}"; return 2; }
  fi
  mkdir -p "$build" && printf '%s\n' "$want" >"$stamp"
}

setup_build() { # arguments: targets
  local werror=OFF log="$build/configure.log"
  [ "${CI:-}" = true ] && werror=ON
  mkdir -p "$build"
  if [ ! -f "$build/build.ninja" ]; then
    say "Configuring"
    (cd "$root" && cmake --preset release -DSHADOWBENCH_WERROR=$werror) >"$log" 2>&1 ||
      { cat "$log" >&2; return 1; }
  fi
  # Only a build that takes its time is worth a word, and then one every half minute.
  (
    sleep 1 >/dev/null 2>&1 && say "Building (several minutes the first time; $build/build.log)"
    while sleep 30 >/dev/null 2>&1; do
      say "  $(grep -o '^\[[0-9/]*\]' "$build/build.log" | tail -n 1)"
    done
  ) &
  local notice=$! status=0
  ninja -C "$build" "$@" >"$build/build.log" 2>&1 || status=$?
  kill $notice 2>/dev/null || true
  wait $notice 2>/dev/null || true
  [ $status = 0 ] || { cat "$build/build.log" >&2; return 1; }
}
