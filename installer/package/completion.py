"""Completion for bash from a command line: commands, options, and the words that an option takes."""
TEMPLATE = """# bash completion for {program}; made from its --help.
{function}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command={program} commands= options= i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$command ${{COMP_WORDS[i]}}" in
      {paths}) command+=" ${{COMP_WORDS[i]}}" ;;
    esac
  done
  case "$command" in
{commands}
  esac
  case "$command $previous" in
{values}
  esac
  [[ $current != -* ]] || commands=$options
  mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
}}
complete -o default -F {function} {program}
"""


def completion(program):
    every = list(program.all())
    name = program.words[0]
    paths = " | ".join(f'"{" ".join(each.words)}"' for each in every[1:]) or '""'
    commands, values, free = [], [], []
    for each in every:
        path = " ".join(each.words)
        words = " ".join(command.words[-1] for command in each.commands)
        options = " ".join(name for option in each.options for name in option.names)
        commands.append(f'    "{path}") commands="{words}" options="{options}" ;;')
        for option in each.options:
            spellings = [f'"{path} {spelling}"' for spelling in option.names]
            if option.choices:
                values.append(f'    {" | ".join(spellings)}) commands="{" ".join(option.choices)}" ;;')
            elif option.value:
                free += spellings
    if free:  # a file or a number: what bash completes by itself
        values.append(f'    {" | ".join(free)}) return ;;')
    return TEMPLATE.format(program=name, function="_" + name.replace("-", "_"), paths=paths, commands="\n".join(commands),
                           values="\n".join(values))
