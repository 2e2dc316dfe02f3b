#!/usr/bin/python3
"""links.py PROGRAM [PAGE.md]: no dead link in what people read: README.md, CONTRIBUTING.md, docs/, the API description, what --help says, comments.

Links and pictures of Markdown lead to files that are there, anchors to headings; a page named in running text (docs/fill.md) exists; every file in docs/
that is no page is shown or linked by one. Words of the program that pages use exist: options of commands, settings, formats.
"""
import json, re, subprocess, sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
LINK = re.compile(r"\]\(([^)\s]+)\)")
NAMED = re.compile(r"(?<![\w/])docs/[\w/-]+\.md\b")
FROM_PAGE = re.compile(r"(?<![\w/`-])(?:exports|howto)/[\w-]+\.md\b")
OPTION = re.compile(r"(?<![\w-])--([a-z][a-z-]+)")
OTHERS = {"all", "only", "lkh", "build", "target", "preset", "gtest", "no-install-recommends", "site", "check", "once", "install", "config-settings"}  # of ./test, scripts/, cmake, ros2, pip


def sources():
    for folder, ends in (("src", {".hpp", ".cpp", ".txt"}), ("apps", {".hpp", ".cpp"}), ("tests", {".cpp", ".hpp"}), ("bench", {".py", ".cpp"}), ("web/src", {".ts", ".tsx"})):
        yield from (path for path in (ROOT / folder).rglob("*") if path.suffix in ends)


def anchor(heading):
    """as repositories and the site make them"""
    return re.sub(r"[\s]", "-", re.sub(r"[^\w\s-]", "", heading.strip().lower()))


def prose(text):
    """without blocks of code and what stands between backticks"""
    out, fenced = [], False
    for line in text.split("\n"):
        if line.startswith("```"): fenced = not fenced
        elif not fenced and not line.startswith("    "): out.append(re.sub(r"`[^`]*`", "", line))
    return "\n".join(out)


def page_faults(page):
    text = page.read_text()
    plain = prose(text)
    for link in LINK.findall(plain):
        target, _, place = link.partition("#")
        if re.match(r"[a-z]+:", target): continue
        path = (page.parent / target).resolve() if target else page
        if not path.exists(): yield f"{page.relative_to(ROOT)}: {link} leads nowhere"
        elif place and place not in {anchor(h) for h in re.findall(r"^#+ (.*)", path.read_text(), re.M)}:
            yield f"{page.relative_to(ROOT)}: {link} names no heading"
    if page.is_relative_to(DOCS):
        for name in FROM_PAGE.findall(plain):
            if not (DOCS / name).exists(): yield f"{page.relative_to(ROOT)}: {name} is not there"
    for name in NAMED.findall(text):
        if not (ROOT / name).exists(): yield f"{page.relative_to(ROOT)}: {name} is not there"


def unused(pages):
    """files of docs/ that no page shows or links"""
    used = set()
    for page in pages:
        for link in LINK.findall(page.read_text()): used.add((page.parent / link.partition("#")[0]).resolve())
    return [f"{path.relative_to(ROOT)}: no page shows it" for path in sorted(DOCS.rglob("*")) if path.is_file() and path.suffix != ".md" and path not in used]


def word_faults(program, pages):
    """options, settings and formats that pages name and the program does not know"""
    says = lambda *words: subprocess.run([program, *words], capture_output=True, text=True, check=True).stdout
    helps = says("--help")
    commands = re.findall(r"^  ([a-z]+)  ", helps[helps.index("Subcommands:"):], re.M)
    helps += "".join(says(command, "--help") for command in commands)
    for name in NAMED.findall(helps):
        if not (ROOT / name).exists(): yield f"--help: {name} is not there"
    options = set(OPTION.findall(helps)) | OTHERS
    keys = {line.split()[0] for line in says("settings").splitlines() if line and not line.startswith(" ")}
    groups = {key.split(".")[0] for key in keys}
    formats = {line.split()[0] for line in says("formats").splitlines()}
    for page in pages:
        text, name = page.read_text(), page.relative_to(ROOT)
        if page.name in ("CONTRIBUTING.md", "options-2014.md"): continue  # options of other programs
        for command in commands:
            # of this command, up to the end of its line or its backticks; what follows a pipe is another's
            for line in re.findall(rf"(?:strandline|\./run) {command}\b([^`\n|&;]*)", text):
                for option in set(OPTION.findall(line.split(" # ")[0])) - options: yield f"{name}: {command} --{option} is no option"
        for option in re.findall(r"`--([a-z][a-z-]+)(?![\w])", text):
            if option not in options: yield f"{name}: --{option} is no option"
        for key in re.findall(r"`([a-z]+\.[a-z_]+)[`=]", text):
            if key.split(".")[0] in groups and key not in keys and not (key.startswith("robot.")) and not re.search(r"\.(md|csv|toml|json|svg|cpp|hpp|py)$", key):
                yield f"{name}: {key} is no setting"
        for form in re.findall(r"export [^`\n|]*--format ([a-z-]+)", text):
            if form not in formats: yield f"{name}: {form} is no format"
    spoken = "".join(page.read_text() for page in pages)
    for form in sorted(formats):
        if not re.search(rf"`?{form}`?", spoken): yield f"no page speaks of the format {form}"
    for command in commands:
        if not re.search(rf"(?:strandline|\./run) {command}\b", spoken): yield f"no page speaks of strandline {command}"


def main(program, more):
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.rglob("*.md")), *(Path(page).resolve() for page in more)]
    faults = [fault for page in pages for fault in page_faults(page)] + unused(pages) + list(word_faults(program, pages))
    described = (ROOT / "web/public/openapi.json").read_text()
    json.loads(described)
    for path, text in [(ROOT / "web/public/openapi.json", described)] + [(path, path.read_text()) for path in sources()]:
        faults += [f"{path.relative_to(ROOT)}: {name} is not there" for name in NAMED.findall(text) if not (ROOT / name).exists()]
    for fault in faults: print(fault, file=sys.stderr)
    print(f"{len(pages)} pages, {len(faults)} faults")
    return 1 if faults else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
