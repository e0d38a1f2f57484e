# Completion of shoal for bash. Commands and options are those of `shoal --help`, keys of --set those
# of the mission file on the command line, vehicles those of the mission that runs.

# Prints the help of the command that the words name: shoal, and up to two commands.
_shoal_help() {
  "${COMP_WORDS[0]}" "$@" --help 2> /dev/null
}

_shoal_commands() {
  sed -n '/^Subcommands:/,/^[^ ]/s/^  \([a-z][a-z_-]*\).*/\1/p'
}

_shoal_options() {
  sed -n 's/^  \(-[^ ]*\).*/\1/p' | tr ',' '\n'
}

_shoal_vehicles() {
  "${COMP_WORDS[0]}" status 2> /dev/null | sed -n 's/^vehicle_sim_\([^ ]*\) .*/\1/p'
}

_shoal() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local words=() word help commands mission
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    commands=$(_shoal_help "${words[@]}" | _shoal_commands)
    if grep -qxF -- "$word" <<< "$commands"; then words+=("$word"); else break; fi
  done
  for word in "${COMP_WORDS[@]:1}"; do
    if [[ $word == *.toml && -f $word ]]; then mission=$word; fi
  done
  help=$(_shoal_help "${words[@]}")
  commands=$(_shoal_commands <<< "$help")

  if [[ $previous == --set ]]; then
    [[ -n $mission ]] || return
    mapfile -t COMPREPLY < <(compgen -S = -W "$("${COMP_WORDS[0]}" check "$mission" --keys \
      2> /dev/null)" -- "$current")
    compopt -o nospace
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_shoal_options <<< "$help")" -- "$current")
  elif [[ $previous == -* ]] && word=$(grep -F -- "$previous" <<< "$help" |
    sed -n 's/.*{\([^}]*\)}.*/\1/p') && [[ -n $word ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${word//,/ }" -- "$current")
  elif [[ -n $commands && ${#words[@]} -eq $((COMP_CWORD - 1)) ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
  elif [[ ${words[0]} == send && $previous == send ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_shoal_vehicles) all clock" -- "$current")
  elif [[ ${words[0]} == url && $previous == url || $previous == --from || $previous == --to ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_shoal_vehicles)" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    compopt -o filenames
  fi
}

complete -F _shoal shoal
