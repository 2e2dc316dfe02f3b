# Sourced by ./run and ./test: installs what is missing, configures and builds. Says what it does on stderr, and nothing when there is
# nothing to do. Needs Debian 12 (or a system whose apt has the same packages), as root or with sudo.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }
die() { say "strandline: $*"; exit 1; }

# install NAME PACKAGE...: a stamp keeps the check fast; a changed list checks again.
install_packages() {
    local name=$1 stamp missing list
    shift
    list="$*"
    stamp="$root/build/.packages-$name"
    [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$list" ] && return
    command -v apt-get >/dev/null || die "apt-get is not on this system; install these Debian packages by other means, then create $stamp with this list in it: $list"
    missing=()
    local package
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' || missing+=("$package")
    done
    if [ ${#missing[@]} -gt 0 ]; then
        say "installing ${#missing[@]} packages: ${missing[*]}"
        local sudo=()
        if [ "$(id -u)" -ne 0 ]; then
            command -v sudo >/dev/null || die "packages are missing and this is neither root nor a user with sudo; run: apt-get install ${missing[*]}"
            sudo=(sudo)
        fi
        mkdir -p "$root/build"
        local log="$root/build/packages.log"
        { "${sudo[@]}" apt-get update -q && "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"; } \
            >"$log" 2>&1 || { tail -n 5 "$log" >&2; die "installing packages failed; the whole log is in $log"; }
    fi
    mkdir -p "$root/build"
    printf '%s' "$list" >"$stamp"
}

build_packages=(g++ cmake ninja-build ccache pkg-config libpugixml-dev libpolyclipping-dev libspiro-dev libcgal-dev libboost-dev nlohmann-json3-dev
    libcli11-dev libtomlplusplus-dev libfmt-dev libexpected-dev libcairo2-dev libpng-dev libjpeg-dev libexif-dev libpotrace-dev libgif-dev libpango1.0-dev libcpp-httplib-dev hershey-fonts-data libgeographiclib-dev)
# Node.js and npm build the editor's pages: what is on PATH is used, and installed only where nothing is.
if command -v node >/dev/null && command -v npm >/dev/null; then web_packages=(); else web_packages=(nodejs npm); fi
browser_packages=(chromium)
# What the Python module is built with and needs (docs/python.md).
python_packages=(pybind11-dev python3-dev python3-numpy)
test_packages=(libgtest-dev librapidcheck-dev clang-format python3 librsvg2-bin fonts-dejavu-core gdal-bin python3-yaml python3-jsonschema poppler-utils groff-base
    "${python_packages[@]}" python3-pytest python3-scipy python3-networkx mypy python3-venv python3-pip)
judge_packages=(python3-shapely python3-numpy python3-scipy)

# Where apt of this machine takes packages from: files for mmdebstrap, which makes other systems from the same place.
debian_sources() {
    local file
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; do
        if [ -s "$file" ]; then echo "$file"; fi
    done
}

# The editor's pages, into web/dist: built when there are none or their sources have changed.
build_web() {
    local log="$root/build/web.log" lock sources
    install_packages web "${web_packages[@]}"
    cd "$root/web" || die "there is no web/"
    lock=$(sha256sum package-lock.json)
    if [ ! -x node_modules/.bin/vite ] || [ "$(cat "$root/build/.web-packages" 2>/dev/null)" != "$lock" ]; then
        say "installing what builds the editor's pages"
        npm ci --no-audit --no-fund >"$log" 2>&1 || { tail -n 10 "$log" >&2; die "npm ci failed; the whole log is in $log"; }
        printf '%s' "$lock" >"$root/build/.web-packages"
    fi
    sources=$(find src public index.html package.json tsconfig.json vite.config.ts -type f ! -name schema.d.ts -exec sha256sum {} + | sort | sha256sum)
    if [ ! -f dist/index.html ] || [ "$(cat "$root/build/.web-sources" 2>/dev/null)" != "$sources" ]; then
        say "building the editor's pages"
        npm run build >"$log" 2>&1 || { grep -v '^npm' "$log" | tail -n 20 >&2; die "building the editor failed; the whole log is in $log"; }
        printf '%s' "$sources" >"$root/build/.web-sources"
    fi
    cd "$OLDPWD" || die "cannot go back"
}

# build PRESET TARGET...: configured once; ninja does the rest and is quick when nothing changed.
build() {
    local preset=$1
    shift
    local folder="$root/build/$preset" log="$root/build/$preset.log"
    if [ ! -f "$folder/build.ninja" ]; then
        say "configuring $preset"
        (cd "$root" && cmake --preset "$preset") >"$log" 2>&1 || { tail -n 20 "$log" >&2; die "configuring failed; the whole log is in $log"; }
    fi
    local arguments=()
    local target
    for target in "$@"; do arguments+=(--target "$target"); done
    if [ -t 2 ]; then
        cmake --build "$folder" "${arguments[@]}" 2>&1 | tee "$log" | show_progress
    else
        cmake --build "$folder" "${arguments[@]}" >"$log" 2>&1
    fi
    local code=${PIPESTATUS[0]}
    [ "$code" -eq 0 ] || { grep -E -A 5 'error|FAILED' "$log" | head -n 40 >&2; die "building failed; the whole log is in $log"; }
}

# One line that counts along, on a terminal.
show_progress() {
    local line
    while IFS= read -r line; do
        case $line in
            '['*/*']'*) printf '\r\033[Kbuilding %s' "${line%%]*}]" >&2 ;;
        esac
    done
    printf '\r\033[K' >&2
}
