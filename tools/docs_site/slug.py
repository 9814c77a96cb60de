"""Anchors of headings, for MkDocs: the same as those of tools/citations.py."""
import re


def slug(heading, separator):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", separator)
