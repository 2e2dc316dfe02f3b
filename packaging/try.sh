# try.sh ROOT PACKAGE: installs the package in the Debian under ROOT, uses it, removes it. For scripts/package --check, as root.
set -eu
root=$1 package=$2

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
# What a system is made of: packages, and files but those in which apt and dpkg keep their accounts.
standing() {
    inside dpkg-query -W -f '${Package} ${Version} ${Status}\n'
    inside find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /var/cache -o -path /var/log -o -path /var/lib/dpkg -o -path /var/lib/apt \) -prune -o -print | sort
}
# Asks the server for a page with nothing but bash.
ask() {
    inside bash -c "exec 3<>/dev/tcp/127.0.0.1/$1; printf 'GET $2 HTTP/1.1\r\nHost: localhost:$1\r\nConnection: close\r\n\r\n' >&3; cat <&3"
}

before=$(standing)
cp "$package" "$root/tmp/strandline.deb"
inside apt-get install -y -q --no-install-recommends /tmp/strandline.deb
echo "ok: installed, $(inside dpkg-query -W -f '${Version} for ${Architecture}, ${Installed-Size} kB' strandline)"
standing | grep '^/usr/bin/strandline$'  # or the comparison at the end would prove nothing

inside strandline --version
drawings=/usr/share/doc/strandline/drawings
inside strandline plan $drawings/starfish.svg -o /tmp/starfish.json
inside strandline check /tmp/starfish.json
inside strandline render /tmp/starfish.json -o /tmp/starfish.png
inside strandline plan --text "sand" --height 1m -o /tmp/text.json
inside strandline plan $drawings/sun.svg $drawings/waves.svg --out-dir /tmp/plans -j 2
echo "ok: plans, proves, draws, letters"
inside test -s /usr/share/man/man1/strandline.1.gz
inside bash -c 'source /usr/share/bash-completion/completions/strandline && COMP_WORDS=(strandline pla) COMP_CWORD=1 && _strandline && [ "$COMPREPLY" = plan ]'
inside test -s /usr/share/doc/strandline/copyright
echo "ok: manual page, completion, licence"

chroot "$root" strandline serve $drawings/starfish.svg --folder /tmp --port 0 --json >"$root/tmp/served" 2>/dev/null &
server=$!
trap 'kill $server 2>/dev/null || true' EXIT
for _ in $(seq 100); do
    grep -q '"port"' "$root/tmp/served" && break
    sleep 0.1
done
port=$(sed 's/.*"port":\([0-9]*\).*/\1/' "$root/tmp/served")
ask "$port" / | grep -q '<script'
ask "$port" /api/v1/about | grep -q '"program"'
kill $server
wait $server
trap - EXIT
echo "ok: serves the editor"

inside apt-get purge -y -q --auto-remove strandline
rm -rf "${root:?}"/tmp/*
diff <(echo "$before") <(standing)
echo "ok: removed, nothing is left"
