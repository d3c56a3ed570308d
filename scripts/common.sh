# SPDX-License-Identifier: MIT
# Shared by ./run and ./check: installing what is missing, building a preset. Expects $root.

# say TEXT: one line for the person at the terminal.
say() { printf 'inkbench: %s\n' "$*" >&2; }

die() {
  say "error: $*"
  exit 1
}

# install_missing GROUP...: installs the packages of those groups that are not there. Nothing missing: no network, no sudo.
install_missing() {
  local groups wanted installed missing package
  groups=" $* "
  wanted=$(while read -r package group _; do
    case "$package" in '' | '#'*) continue ;; esac
    case "$groups" in *" $group "*) echo "$package" ;; esac
  done <"$root/packages.txt")
  # shellcheck disable=SC2086
  installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' $wanted 2>/dev/null | awk '$1 ~ /^.i/ {print $2}' || true)
  missing=
  for package in $wanted; do
    grep -qx -- "$package" <<<"$installed" || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0

  command -v apt-get >/dev/null || die "these Debian packages are missing and there is no apt-get:$missing"
  local as_root=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || die "run this as root once, or install these packages:$missing"
    as_root=sudo
  fi
  say "installing$missing"
  $as_root apt-get update -qq >&2 || say "apt-get update failed; trying with the lists that are here"
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >&2 ||
    die "apt-get could not install:$missing"
}

# build_preset PRESET TESTS [TARGET...]: configures once, then builds; prints only what matters. TESTS is ON or OFF: whether
# the tests belong to it; a folder that has them keeps them.
build_preset() {
  local preset=$1 tests=$2 folder=$root/build/$1
  shift 2
  mkdir -p "$folder"
  # A build folder remembers where its sources were; a moved or copied one starts over.
  if [ -f "$folder/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    rm -rf "${folder:?}"/*
  fi
  (
    flock 9 # two starts at once: the second waits for the first one's build
    if [ ! -f "$folder/build.ninja" ]; then
      say "configuring and building ($preset); the first time takes a few minutes"
      configure "$preset" "$tests"
    elif [ "$tests" = ON ] && ! grep -q '^INKBENCH_TESTS:.*=ON$' "$folder/CMakeCache.txt"; then
      configure "$preset" ON
    fi
    ninja -C "$folder" "$@" >"$folder/build.log" 2>&1 || {
      grep -v '^\[[0-9]*/[0-9]*\]' "$folder/build.log" | tail -n 60 >&2
      die "the build failed; all of its output is in $folder/build.log"
    }
  ) 9>"$folder/.lock"
}

# configure PRESET TESTS
configure() {
  local log=$root/build/$1/configure.log
  (cd "$root" && cmake --preset "$1" -D INKBENCH_TESTS="$2") >"$log" 2>&1 || {
    cat "$log" >&2
    die "cmake could not configure build/$1"
  }
}
