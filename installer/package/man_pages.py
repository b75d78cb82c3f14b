"""Man pages from a command line."""
import re

EXIT = {
    "fyd": ["0", "What was asked is done.", "1", "It failed; standard error says why.", "2", "Wrong usage."],
    "fyd-console": ["0", "The window was closed.", "1", "A file or the session could not be opened.", "2", "Wrong usage.",
                    "128 + N", "Ended by signal N, with the recording closed."],
}


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("^", "\\(ha").replace("~", "\\(ti")
    # A list or a path without spaces may break within.
    return re.sub(r"([,/])(?=\S)", r"\1\\:", re.sub(r"^\.", r"\\&.", text.strip()))


def arguments(title, listed):
    out = [f".SS {title}"] if listed else []
    for each in listed:
        names = ", ".join(f"\\fB{roff(name)}\\fR" for name in each.names)
        out += [".TP", f"{names} \\fI{roff(each.value)}\\fR".replace(" \\fI\\fR", ""), roff(each.help) or "\\&"]
    return out


def body(command):
    out = arguments("Arguments", command.positionals) + arguments("Options", command.options)
    if command.commands:
        out.append(".SS Commands")
    for each in command.commands:
        out += [".TP", f"\\fB{roff(' '.join(each.words))}\\fR", roff(each.summary)]
    return out


def page(command, version, date, see):
    name = "-".join(command.words)
    out = [f'.TH {roff(name.upper())} 1 "{date}" "FYD Console {version}" "FYD Console"', ".nh", ".ad l", ".SH NAME",
           f"{roff(name)} \\- {roff(re.sub(r'^[A-Z](?![A-Z])', lambda letter: letter[0].lower(), command.summary))}", ".SH SYNOPSIS",
           f"\\fB{roff(' '.join(command.words))}\\fR {roff(command.usage.removeprefix(' '.join(command.words)))}",
           ".SH DESCRIPTION", roff(command.summary[:1].upper() + command.summary[1:]) + ".", *body(command)]
    for each in list(command.all())[1:]:
        if len(command.words) > 1:  # of the program itself each command has a page
            out += [f".SH {roff(' '.join(each.words).upper())}", roff(each.summary) + ".", ".PP",
                    f"\\fB{roff(' '.join(each.words))}\\fR {roff(each.usage.removeprefix(' '.join(each.words)))}", *body(each)]
    out.append(".SH EXIT STATUS")
    status = EXIT[command.words[0]]
    for code, meaning in zip(status[::2], status[1::2]):
        out += [".TP", roff(code), roff(meaning)]
    out += ["Some commands have codes of their own, which their help names."] if command.words[0] == "fyd" else []
    out += [".SH SEE ALSO", ", ".join(f"\\fB{roff(each)}\\fR(1)" for each in see if each != name)]
    return name, "\n".join(out) + "\n"


def pages(program, version, date):
    """name of the file -> text, for the program and each of its commands."""
    commands = [program, *program.commands]
    names = ["-".join(each.words) for each in commands]
    others = ["fyd-console"] if program.words == ["fyd"] else ["fyd"]
    return {f"{name}.1": text for name, text in
            (page(each, version, date, (names if each is program else names[:1]) + others) for each in commands)}
