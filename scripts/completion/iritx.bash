# Completion of iritx for bash: options, commands, files, function names behind
# --help. Options and commands are asked from the program itself.
_iritx()
{
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} w
    COMPREPLY=()
    case $prev in
    --help)
        w=$(iritx --list-functions 2>/dev/null | awk '/^[A-Za-z]/ {print tolower($1)}')
        mapfile -t COMPREPLY < <(compgen -W "$w" -- "${cur,,}")
        return
        ;;
    --degree-form) w='minimal published naive irit' ;;
    --format) w='text csv xml' ;;
    --view) w='top bottom front back right left iso' ;;
    --root | --plugin-dir)
        mapfile -t COMPREPLY < <(compgen -d -- "$cur")
        return
        ;;
    esac
    if [ -z "$w" ] && [[ $cur == -* ]]; then
        case " ${COMP_WORDS[*]} " in
        *' draw '*) w='-o --net --knots --shade --view --size --fit --no-axes' ;;
        *' degrees '*) w='--op --format' ;;
        *' convert '*) w='--tol' ;;
        *) w=$(iritx --help 2>/dev/null | awk '/^  -/ {print $1}') ;;
        esac
    elif [ -z "$w" ] && [ "$COMP_CWORD" = 1 ]; then
        w=$(iritx --help 2>/dev/null | awk '/^Commands/ {on = 1} on && /^  [a-z]/ {print $1}')
    fi
    mapfile -t COMPREPLY < <(compgen -W "$w" -- "$cur"; [[ $cur == -* ]] || compgen -f -- "$cur")
}
complete -o filenames -F _iritx iritx
