# Debians with nothing in them, to try things in: functions for scripts in this folder, which source
# this file when they have gone to the root of the checkout.  Such a script calls read_flags, and
# begin_roots before it makes a root.

suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}")  # the name of the Debian
mirror=http://deb.debian.org/debian                                 # where its packages come from
keep=false                                                          # true: the roots stay

say() { echo "$(basename "$0" .sh): $*" >&2; }
give_up() { say "$*"; exit 1; }

# read_flags FLAG=VARIABLE... -- ARGS...: sets the variables of the flags that are in ARGS.  A flag
# whose variable is true or false before is a switch, which makes it true; every other flag has a
# value.  --mirror and --keep are flags of all scripts.  Another argument ends the script with the
# text at the script's top.
read_flags() {
  local -A switches=() values=()
  local flag variable
  set -- --mirror=mirror --keep=keep "$@"
  while [ "$1" != -- ]; do
    flag=${1%%=*} variable=${1#*=}
    case ${!variable} in
      true | false) switches[$flag]=$variable ;;
      *) values[$flag]=$variable ;;
    esac
    shift
  done
  shift
  while [ $# -gt 0 ]; do
    # Bash takes other words, such as * and the empty one, for more than the name of an element.
    flag=
    case $1 in --?*) flag=$1 ;; esac
    if [ -n "$flag" ] && [ -n "${switches[$flag]:-}" ]; then
      printf -v "${switches[$flag]}" true
    elif [ -n "$flag" ] && [ -n "${values[$flag]:-}" ]; then
      case ${2:---} in --*) give_up "$flag needs a value" ;; esac
      printf -v "${values[$flag]}" %s "$2"
      shift
    else
      sed -n '2,/^set /s/^# \{0,1\}//p' "tools/$(basename "$0")" >&2
      exit 2
    fi
    shift
  done
}

# need_root: ends the script, with the reason, if no root can be made here.
need_root() {
  [ "$(id -u)" -eq 0 ] || give_up "a clean root needs chroot and mount: call this as root (sudo)"
  command -v debootstrap >/dev/null || give_up "debootstrap is missing; apt-get install debootstrap"
}

# begin_roots: makes the folder $roots, in which the roots are, and removes it at the end.
begin_roots() {
  roots=$(mktemp -d "${TMPDIR:-/tmp}/openr-host-roots.XXXXXX")
  chmod 755 "$roots"
  trap end_roots EXIT
}

end_roots() {
  if $keep; then say "the roots are in $roots"; else rm -rf --one-file-system "$roots"; fi
}

# make_root ROOT: a Debian with nothing in it.
make_root() {
  say "making a root of Debian $suite"
  mkdir -p "$1"
  debootstrap --variant=minbase "$suite" "$1" "$mirror" >"$roots/debootstrap.log" 2>&1 || {
    tail -n 20 "$roots/debootstrap.log" >&2
    give_up "debootstrap failed"
  }
  cp -L /etc/resolv.conf "$1/etc/resolv.conf"
  # A network may have certificates of its own, which npm needs for the page of the panel.
  if [ -n "${NODE_EXTRA_CA_CERTS:-}" ]; then cp -L "$NODE_EXTRA_CA_CERTS" "$1/etc/certificates.crt"; fi
}

# in_root ROOT SCRIPT ARGS...: runs a script in the root.  Mounts and processes of the root end with it.
in_root() {
  unshare --mount --pid --fork bash -c '
    mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && mount -t tmpfs tmpfs "$1/run" &&
      root=$1 && shift && exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb \
        ${NODE_EXTRA_CA_CERTS:+NODE_EXTRA_CA_CERTS=/etc/certificates.crt} chroot "$root" bash "$@"
  ' bash "$@"
}
