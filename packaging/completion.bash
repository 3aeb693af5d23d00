# bash completion for placode, placode-sim, placodectl and placode-web: asks the programs themselves, so that it is never behind.
_placode() {
  local word=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]} help i
  local -a path=()
  if [ "${program##*/}" = placodectl ]; then
    for ((i = 1; i < COMP_CWORD; ++i)); do
      [[ ${COMP_WORDS[i]} =~ ^[a-z][a-z-]*$ ]] && path+=("${COMP_WORDS[i]}")
    done
  fi
  help=$("$program" "${path[@]}" --help 2>/dev/null) || help=$("$program" --help 2>/dev/null)
  local words
  if [[ $word == -* ]]; then
    words=$(grep -oE -- '--[a-z][a-z-]*' <<<"$help" | sort -u)
  else
    words=$(sed -n '/^Subcommands:/,$p' <<<"$help" | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p')
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  [ ${#COMPREPLY[@]} -gt 0 ] || mapfile -t COMPREPLY < <(compgen -f -- "$word")
}
complete -o filenames -F _placode placode placode-sim placodectl placode-web
