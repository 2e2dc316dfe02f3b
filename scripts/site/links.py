"""links.py SITE DOCS MKDOCS_YML: every link, anchor and picture of the built pages is there, nothing is loaded from another host, and
every page of docs/ is in the navigation. The pages as they lie in the repository are tests/docs/links.py's business."""
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import yaml

LOADED = {"img": "src", "script": "src", "link": "href", "iframe": "src", "source": "src"}


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[key] for key in ("id", "name") if values.get(key)}
        if tag == "a" and values.get("href"): self.links.append(values["href"])
        if tag in LOADED and values.get(LOADED[tag]): self.loads.append(values[LOADED[tag]])


def named(entries):
    for entry in entries:
        for target in entry.values() if isinstance(entry, dict) else [entry]:
            yield from named(target) if isinstance(target, list) else [target]


def main(site, docs, settings):
    pages = {path: Page(path.read_text()) for path in sorted(site.rglob("*.html")) if path.name != "404.html"}  # served from any depth
    faults, links = [], 0
    for path, page in pages.items():
        for link in page.links + page.loads:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loads: faults.append(f"{path}: loads {link} from another host")
                continue
            links += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir(): target /= "index.html"
            if not target.exists(): faults.append(f"{path}: {link} leads nowhere")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors:
                faults.append(f"{path}: {link} names no place on that page")
    listed = set(named(yaml.safe_load(settings.read_text())["nav"]))
    for page in sorted(docs.rglob("*.md")):
        if (name := page.relative_to(docs).as_posix()) not in listed: faults.append(f"mkdocs.yml: nav lacks {name}")
    for fault in faults: print(fault, file=sys.stderr)
    print(f"{len(pages)} pages, {links} links and pictures, {len(faults)} faults", file=sys.stderr)
    return 1 if faults else 0


sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]), Path(sys.argv[3])))
