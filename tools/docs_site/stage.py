"""Copies the documents to a folder of pages for MkDocs, in which every link stays within the site.

Documents keep their paths, so links between them stay as they are.  A link to another file of the
checkout leads to a page with its text, one to a folder to its README.md or a page with its files.
"""
import os
import re
import shutil

FENCE = re.compile(r"^( *)(`{3,}|~{3,})(.*)$")
LINK = re.compile(r"(\]\()([^()\s]+)((?: \"[^\"]*\")?\))")
ITEM = re.compile(r"^ *([-*+]|\d+\.) ")
PICTURES = {".png", ".svg", ".gif", ".jpg"}
LANGUAGES = {".cc": "cpp", ".h": "cpp", ".c": "c", ".py": "python", ".sh": "sh", ".json": "json",
             ".mjs": "javascript", ".ipynb": "json"}
TEXT_MAX = 100_000  # characters of a file on a page


def documents(root):
    """Returns the pages of the site, as paths below `root`."""
    found = [path for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md") for path in [root / name]]
    found += sorted((root / "docs").rglob("*.md")) + sorted((root / "examples").rglob("README.md"))
    return [path.relative_to(root) for path in found if path.is_file()]


def fence_line(indent, mark, info):
    """Returns an opening fence whose info string MkDocs understands (tests/docs/page.py says ours)."""
    words = info.split()
    if not words:
        return f"{indent}{mark}"
    title = next((word.split("=", 1)[1] for word in words[1:] if word.startswith(("file=", "from="))), "")
    if words[0] == "output":
        return f"{indent}{mark}{{ .text .prints }}"
    return f"{indent}{mark}{words[0]}" + (f' title="{title}"' if title else "")


def lines_for_mkdocs(text):
    """Returns the lines with our fences, and with the blank lines that MkDocs needs before a list or table."""
    lines, inside, in_list, before = [], "", False, ""
    for line in text.splitlines():
        fence = FENCE.match(line)
        if inside:
            if fence and fence[2].startswith(inside) and not fence[3].strip():
                inside = ""
        elif fence:
            inside = fence[2]
            line = fence_line(*fence.groups())
        else:
            begins = (ITEM.match(line) and not in_list) or (line.startswith("|") and not before.startswith("|"))
            if begins and before.strip():
                lines.append("")
            if ITEM.match(line):
                in_list = True
            elif not line.strip() or (line.startswith("#")):
                in_list = in_list and not line.startswith("#")
            elif not line.startswith(" ") and not before.strip():
                in_list = False
        lines.append(line)
        before = line
    return lines


class Stage:
    """The folder of pages, while it is filled."""

    def __init__(self, root, folder):
        self.root, self.folder = root, folder
        self.pages = set(documents(root))
        self.sources = set()  # files and folders of the checkout that get a page of their own

    def fill(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        for page in sorted(self.pages):
            self.write(page, self.converted(page))
        for source in sorted(self.sources):
            self.write_source(source)
        shutil.copy(self.root / "tools/docs_site/site.css", self.folder / "site.css")

    def write(self, path, text):
        target = self.folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    def converted(self, page):
        inside, lines = "", []
        for line in lines_for_mkdocs((self.root / page).read_text()):
            fence = FENCE.match(line)
            if fence and (not inside or (fence[2].startswith(inside) and not fence[3].strip())):
                inside = "" if inside else fence[2]
            elif not inside:
                line = LINK.sub(lambda match: match[1] + self.target(page, match[2]) + match[3], line)
            lines.append(line)
        return "\n".join(lines) + "\n"

    def target(self, page, link):
        """Returns where a link of a page leads in the site; one that leads nowhere stays, for MkDocs to refuse."""
        path, _, anchor = link.partition("#")
        if not path or ":" in path:
            return link
        there = os.path.normpath(page.parent / path)
        file = self.root / there
        if there.startswith("..") or not file.exists():
            return link
        name = type(page)(there)
        if name in self.pages:
            return link
        if name / "README.md" in self.pages:
            there = str(name / "README.md")
        elif file.suffix in PICTURES:
            (self.folder / there).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, self.folder / there)
        else:
            self.sources.add(name)
            there = str(self.source_page(name))
        return os.path.relpath(there, page.parent) + (f"#{anchor}" if anchor else "")

    def source_page(self, name):
        page = name / "files" if (self.root / name).is_dir() else name
        visible = [part.lstrip(".") for part in page.parts]  # MkDocs leaves hidden files out
        return type(name)(*visible[:-1], visible[-1] + ".md")

    def write_source(self, name):
        file = self.root / name
        if file.is_dir():
            names = sorted(path.name + "/" * path.is_dir() for path in file.iterdir()
                           if not path.name.startswith((".", "__")))
            text = "Files of this folder in the checkout:\n\n" + "".join(f"- `{each}`\n" for each in names)
        else:
            text = file.read_text(errors="replace")[:TEXT_MAX]
            text = f"~~~~~{LANGUAGES.get(file.suffix, 'text')}\n{text}\n~~~~~\n"
        self.write(self.source_page(name), f"# {name}\n\n{text}")
