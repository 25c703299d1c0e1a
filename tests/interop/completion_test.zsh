#!/usr/bin/env zsh
# completion_test.zsh BANDWAGON FOLDER: what a zsh offers for lines that somebody has begun, and what Tab makes of them, typed into one on a
# pseudo-terminal. FOLDER holds the completion that is installed. Expected as in completion_test.sh; zsh takes a word as a whole, with its =.
zmodload zsh/zpty || exit 1
export XDG_CONFIG_HOME=/nowhere TERM=dumb
program=$1
failed=0

zpty shell zsh -f -i
zpty -w shell "PS1= RPS1= PATH=${(q)program:h}:\$PATH fpath=(${(q)2} \$fpath); autoload -Uz compinit; compinit -D -u; cd /usr"
# Tab leaves the candidates that fit between < >, and ^X the line between { }.
zpty -w shell 'compadd() { local -a fit; builtin compadd -O fit "$@"; ((${#fit})) && print -rn -- "<$fit>"; builtin compadd "$@" }'
zpty -w shell 'line() { print -rn -- "{$BUFFER}"; BUFFER= }; zle -N line; bindkey "^X" line; bindkey "^I" complete-word; unsetopt autolist'
zpty -w shell 'stty -echo; print STAR""TED'
zpty -r shell seen '*STARTED*'

offers() { # offers LINE LINE_AFTER_TAB CANDIDATE...
  local begun=$1 line=$2 seen got=() candidates=("${@:3}")
  zpty -w -n shell "$begun"$'\t\x18'
  zpty -r shell seen '*[{]*[}]'
  [[ $seen == *\<*\>* ]] && got=(${=${seen##*\<}%%\>*})
  seen=${${seen##*\{}%\}}
  [[ ${(j: :)${(o)got}} == ${(j: :)${(o)candidates}} && $seen == $line ]] && return
  print -rl -- "$begun<TAB>" " expected: $line | $candidates" "      got: $seen | $got"
  failed=1
}

offers "bandwagon re" "bandwagon re" record replay reproduce
offers "bandwagon-lab reprod" "bandwagon-lab reproduce " reproduce
offers "bandwagon bag co" "bandwagon bag convert " convert
offers "bandwagon map --ov" "bandwagon map --overwrite " --overwrite
offers "bandwagon run hallway --clock " "bandwagon run hallway --clock " lockstep topic wall
offers "bandwagon run robot --set robot=ko" "bandwagon run robot --set robot=kobuki " robot=kobuki
offers "bandwagon run hallway --set local_planner.algorithm=te" "bandwagon run hallway --set local_planner.algorithm=teb" \
  local_planner.algorithm={teb,teb_homotopy}
# A value is to come: no blank.
offers "bandwagon run hallway --set local_planner.alg" "bandwagon run hallway --set local_planner.algorithm=" local_planner.algorithm=
offers "bandwagon enable jack" "bandwagon enable jackal " jackal
offers "bandwagon evaluate hallway --planners teb,pt" "bandwagon evaluate hallway --planners teb,pteb " teb,pteb
# Files are zsh's own.
offers "bandwagon bag info loc" "bandwagon bag info local/" local
exit $failed
