#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
# A store on one computer that several people log in to: local PostgreSQL over its Unix socket. Its
# files belong to the server's user; who connects, the kernel tells the server (peer authentication).
#
#   sudo scripts/shared_station.sh LOGIN...      people of this computer who may use the store
#
# It may be run again at any time: after an update of Placode, and with further people.
set -euo pipefail

database=placode owner=placode server_user=postgres socket=/var/run/postgresql placodectl=placodectl
usage() {
    sed -n '4,10s/^# \{0,1\}//p' "$0"
    cat <<'END'

  --database NAME     (placode)
  --owner LOGIN       a user of this computer who owns the tables (placode; made if missing)
  --server-user LOGIN whom the server runs as (postgres)
  --socket FOLDER     of the server's socket (/var/run/postgresql)
  --placodectl FILE   (placodectl)
END
}
fail() { echo "shared_station: $*" >&2; exit 2; }
people=()
while [ $# -gt 0 ]; do
    case $1 in
        --database | --owner | --server-user | --socket | --placodectl)
            [ $# -ge 2 ] || fail "$1 needs a value"
            option=${1#--}
            printf -v "${option//-/_}" '%s' "$2"
            shift 2
            ;;
        -h | --help) usage; exit 0 ;;
        -*) fail "unknown option $1; --help lists them" ;;
        *) people+=("$1"); shift ;;
    esac
done
# These become part of SQL and of a line of pg_hba.conf.
for name in "$database" "$owner" "$server_user" ${people[@]+"${people[@]}"}; do
    [[ $name =~ ^[a-z_][a-z0-9_-]{0,31}$ ]] || fail "found the name \"$name\"; expected small letters, digits, _ and -"
done
[ "$(id -u)" = 0 ] || fail "only root may act as the server's user; run it with sudo"
id "$server_user" > /dev/null 2>&1 || fail "there is no user $server_user; install postgresql first"
for name in ${people[@]+"${people[@]}"}; do
    id "$name" > /dev/null 2>&1 || fail "there is no user $name on this computer"
    [ "$name" != "$owner" ] && [ "$name" != "$server_user" ] ||
        fail "$name owns the tables or the files; who trains needs a login of their own"
done

as_server() { (cd / && PGOPTIONS='-c client_min_messages=warning' runuser -u "$server_user" -- psql -h "$socket" -XqAt -v ON_ERROR_STOP=1 "$@"); }
as_server -d postgres -c 'SELECT 1' > /dev/null || fail "no server answers at $socket"
id "$owner" > /dev/null 2>&1 ||
    useradd --system --user-group --no-create-home --shell /usr/sbin/nologin "$owner"

# --- roles and database
role() { # NAME OPTIONS
    as_server -d postgres -c "DO \$\$ BEGIN IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = '$1') THEN
        CREATE ROLE \"$1\" $2; END IF; END \$\$"
}
role "$owner" LOGIN
role placode_station NOLOGIN
role placode_service "NOLOGIN IN ROLE placode_station"
if [ -z "$(as_server -d postgres -c "SELECT 1 FROM pg_database WHERE datname = '$database'")" ]; then
    as_server -d postgres -c "CREATE DATABASE \"$database\" OWNER \"$owner\" TEMPLATE template0 ENCODING 'UTF8'"
fi
for name in ${people[@]+"${people[@]}"}; do
    role "$name" LOGIN
    as_server -d postgres -c "GRANT placode_station TO \"$name\""
done

# --- who may come in: the kernel's word, over the socket alone. The first line that fits counts.
hba=$(as_server -d postgres -c 'SHOW hba_file')
begin="# placode $database: begin (scripts/shared_station.sh)" end="# placode $database: end"
new=$(mktemp)
trap 'rm -f "$new"' EXIT
{
    printf '%s\nlocal "%s" all peer\nhost "%s" all all reject\n%s\n' "$begin" "$database" "$database" "$end"
    awk -v begin="$begin" -v end="$end" '$0 == begin { skip = 1 } !skip; $0 == end { skip = 0 }' "$hba"
} > "$new"
if ! cmp -s "$new" "$hba"; then
    # In the place of the old one at once: a server that starts meanwhile reads a whole file.
    install -o "$(stat -c %u "$hba")" -g "$(stat -c %g "$hba")" -m "$(stat -c %a "$hba")" "$new" "$hba.placode"
    mv "$hba.placode" "$hba"
fi
as_server -d postgres -c 'SELECT pg_reload_conf()' > /dev/null
wrong=$(as_server -d postgres -c "SELECT string_agg(line_number || ': ' || error, '; ') FROM pg_hba_file_rules WHERE error IS NOT NULL")
[ -z "$wrong" ] || fail "$hba: $wrong"

# --- tables and rights, by their owner
home=$(mktemp -d)
trap 'rm -rf "$new" "$home"' EXIT
chown "$owner" "$home"
url="postgresql:///$database?host=$socket"
(cd / && runuser -u "$owner" -- env HOME="$home" XDG_DATA_HOME="$home" XDG_CONFIG_HOME="$home" \
    "$placodectl" --store "$url" station role --apply)

# --- what the whole thing is for
files=$(as_server -d postgres -c 'SHOW data_directory')
for name in ${people[@]+"${people[@]}"}; do
    ! runuser -u "$name" -- test -r "$files" || fail "$name can read $files"
done
echo "The store of this computer: placode --store '$url'"
