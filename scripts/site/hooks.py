"""mkdocs hooks: the pages are written for the repository's own view and for the site at once.

- A page named in running text (docs/fill.md, exports/wpl.md) becomes a link, so that a dead one is an error of the strict build.
- Links out of docs/ (../web/public/openapi.json, ../drawings/crab.svg) lead to copies under repo/.
- Lists and tables that follow a line of text directly get the empty line that this Markdown asks for.
"""
import posixpath, re
from pathlib import Path

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
FROM_ROOT = ("CONTRIBUTING.md",)  # pages of the site that lie beside docs/
HOME = {"../README.md": "index.md"}
LINK = re.compile(r"\]\(((?:\.\./)+[^)#\s]+)")
MENTION = re.compile(r"(?<!\]\()(?<![\w/\[`-])(docs/)?((?:[\w-]+/)?[\w-]+\.md)\b(?![\]`])")
ITEM = re.compile(r"\s{0,3}(?:[-*]|\d+\.) ")


def outside(page, link):
    """-> path from the root of what a link out of docs/ points at, or None for a page of docs/"""
    path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), link))
    return None if path.startswith("docs/") else path


def on_files(files, config):
    wanted = set()
    for page in Path(config["docs_dir"]).rglob("*.md"):
        name = page.relative_to(config["docs_dir"]).as_posix()
        wanted |= {path for link in LINK.findall(page.read_text()) if (path := outside(name, link)) and link not in HOME}
    for path in sorted(wanted - set(FROM_ROOT)):
        copy = File(path, str(ROOT), config["site_dir"], False)
        copy.dest_uri = copy.dest_path = copy.url = copy.src_uri = copy.src_path = f"repo/{path}"
        copy.abs_src_path, copy.abs_dest_path = str(ROOT / path), str(Path(config["site_dir"]) / "repo" / path)
        files.append(copy)
    for path in FROM_ROOT:
        files.append(File(path, str(ROOT), config["site_dir"], False))
    return files


def on_page_markdown(markdown, page, config, files):
    name = page.file.src_uri
    folder = posixpath.dirname(name)
    here = lambda target: posixpath.relpath(target, folder or ".")

    def led(match):
        link = match[1]
        if link in HOME: return f"]({here(HOME[link])}"
        path = outside(name, link)
        return match[0] if path is None else f"]({here(path if path in FROM_ROOT else 'repo/' + path)}"

    def named(match):
        for target in (match[2], posixpath.join(folder, match[2])):
            if files.get_file_from_path(target): return f"[{match[0]}]({here(target)})"
        return match[0]

    lines, fenced = [], False
    for line in markdown.split("\n"):
        before = lines[-1] if lines else ""
        if line.startswith("```"): fenced = not fenced
        if fenced or line.startswith("    "):
            lines.append(line)
            continue
        line = LINK.sub(led, line)
        # every second piece lies between backticks, where nothing is a link
        line = "`".join(piece if k % 2 else MENTION.sub(named, piece) for k, piece in enumerate(line.split("`")))
        begins = (ITEM.match(line) and not ITEM.match(before)) or (line.startswith("|") and not before.startswith("|"))
        if begins and before.strip() and not before.startswith((" ", "#")) and not (ITEM.match(line) and in_list(lines)):
            lines.append("")
        lines.append(line)
    return "\n".join(lines)


def in_list(lines):
    """whether the paragraph that ends here began as an item of a list"""
    for line in reversed(lines):
        if not line.strip(): return False
        if ITEM.match(line): return True
    return False
