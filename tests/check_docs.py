#!/usr/bin/env python3
# check_docs.py: fails when a link of a Markdown page leads to no file or heading, when a page names a file or a suite that
# is not there, when the code of a page is not that of the program that the page says it is from, or when docs/README.md
# lacks a page.
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import re
import sys

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
failures = []


def pages():
    for folder, folders, names in os.walk(root):
        folders[:] = [f for f in folders if f not in ("build", ".git", "node_modules") and not f.startswith("build-")]
        for name in names:
            if name.endswith(".md"):
                yield os.path.relpath(os.path.join(folder, name), root)


def text_of(page):
    with open(os.path.join(root, page), encoding="utf-8") as file:
        return file.read()


def anchors(page):
    """The anchors of a page's headings, as GitHub makes them."""
    text = re.sub(r"^```.*?^```", "", text_of(page), flags=re.S | re.M)
    found = set()
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        found.add(re.sub(r"[^\w\- ]", "", heading).strip().replace(" ", "-"))
    return found


def blocks(page):
    """The indented blocks of a page, each with single spaces."""
    text = re.sub(r"^```.*?^```", "", text_of(page), flags=re.S | re.M)
    return [" ".join(block.split()) for block in re.findall(r"(?:^(?:    .*)?\n)+", text, re.M) if block.strip()]


suites = {name[:-4] for _, _, names in os.walk(os.path.join(root, "tests")) for name in names if re.match(r"test_\w+\.cpp", name)}
folders_with_code = "core|ui|app|tests|samples|resources|tools|bindings|cmake|shaders"
linked = {}
for page in sorted(pages()):
    for program in re.findall(r"code here is\s+from `([\w/]+\.cpp)`", text_of(page)):
        code = " ".join(text_of(program).split())
        failures += [f"{page}: {program} has no such code: {block[:60]}" for block in blocks(page) if block not in code]
    text = re.sub(r"^```.*?^```", "", text_of(page), flags=re.S | re.M)
    text = "\n".join(line for line in text.split("\n") if not line.startswith("    "))
    linked[page] = set()
    if page != "CHANGELOG.md" and not page.startswith("docs/decisions/"):  # they tell of what was
        for name in re.findall(r"`([\w./-]+)`", text):
            if re.match(rf"(?:{folders_with_code})/", name) and not os.path.exists(os.path.join(root, name)):
                failures.append(f"{page}: there is no file {name}")
            elif re.fullmatch(r"test_\w+", name) and name not in suites:
                failures.append(f"{page}: there is no suite {name}")
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        full = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        linked[page].add(full)
        if not os.path.exists(os.path.join(root, full)):
            failures.append(f"{page}: the link {target} leads to no file")
        elif anchor and full.endswith(".md") and anchor not in anchors(full):
            failures.append(f"{page}: {full} has no heading for the link {target}")

for page in linked:
    if page.startswith("docs/decisions/") and page != "docs/decisions/README.md":
        if page not in linked["docs/decisions/README.md"]:
            failures.append(f"docs/decisions/README.md: lacks {page}; add its line to the table")
    elif page.startswith("docs/") and page not in ("docs/README.md", "docs/decisions/README.md"):
        if page not in linked["docs/README.md"]:
            failures.append(f"docs/README.md: lacks {page}; add it to the list of its kind")

for failure in failures:
    print(failure, file=sys.stderr)
sys.exit(1 if failures else 0)
