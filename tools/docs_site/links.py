"""Checks the pages of a built site: links, anchors, and that no page fetches anything from elsewhere."""
import html.parser
import urllib.parse

FETCHED = {("link", "href"), ("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"),
           ("audio", "src"), ("video", "src"), ("object", "data"), ("embed", "src")}
RELATIONS = {"canonical", "prev", "next"}  # values of rel in <link> for which nothing is fetched


class Page(html.parser.HTMLParser):
    """Anchors, links and fetched addresses of a page."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.fetched = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors.update(values[key] for key in ("id", "name") if values.get(key))
        for key in ("href", "src", "data"):
            if values.get(key) is None:
                continue
            if (tag, key) in FETCHED and values.get("rel") not in RELATIONS:
                self.fetched.append(values[key])
            if key != "data":
                self.links.append(values[key])


def faults(site):
    """Returns lines "page: fault" of a built site."""
    pages = {path.relative_to(site): Page(path.read_text()) for path in sorted(site.rglob("*.html"))}
    found = []
    for name, page in pages.items():
        found += [f"{name}: fetches {address}" for address in page.fetched
                  if urllib.parse.urlsplit(address).scheme not in ("", "data") or address.startswith("//")]
        for link in sorted(set(page.links)):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            there = name
            if parts.path:
                file = (site / name).parent / urllib.parse.unquote(parts.path)
                if file.is_dir():
                    file = file / "index.html"
                if not file.exists():
                    found.append(f"{name}: there is no {link}")
                    continue
                there = file.resolve().relative_to(site.resolve())
            anchor = urllib.parse.unquote(parts.fragment)
            if anchor and there in pages and anchor not in pages[there].anchors and anchor != "__tabbed":
                found.append(f"{name}: {there} has no #{anchor}")
    return found
