#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks sentences of the manuals, of README.md and the like, of comments of headers, of messages and help, and of
docstrings.
A sentence has at most 25 words, no pronoun in place of a noun ("that of"), and words of the field only.
A comment on lines of its own starts with a capital letter, a digit or a name, and ends with a mark.
The command ingroup of Doxygen has a line of its own.
Prints file:line of each violation, and exits with 1 if there is any. Without arguments all files are
checked."""

import argparse
import ast
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOST_WORDS = 25

TEXTS = ["doc/**/*.txt", "README.md", "CHANGES.md", "CONTRIBUTING.md"]
HEADERS = ["include/CGAL/**/*.h", "doc/*/Concepts/*.h"]
SOURCES = ["demo/**/*.cpp", "demo/**/*.h", "examples/*/*.cpp", "python/src/*.cpp", "python/src/*.h",
           "python/intrinsic/*.py", "python/tutorial/*.py"]

# Pronouns and adverbs that stand for a noun: the noun is to be repeated.
STAND_INS = [
    (r"\bthat of\b", "repeat the noun"),
    (r"\bthose (?:of|in|on|at|with|without|which|that|who|whose|from|to|for|by|above|below|alone|are|is)\b",
     "repeat the noun"),
    (r"\bthose(?=[.,;:)]|$)", "repeat the noun"),
    (r"\bwhat is\b", "name the thing"),
    (r"\bof which\b", "make two sentences, or write 'whose'"),
    # "there is" states existence; elsewhere the word stands for a place that has a name.
    (r"\bthere\b(?! (?:is|are|was|were|has|have|can|may|must|exists?|remains?|be)\b)",
     "name the position"),
]

# Words for which the field has another one.
DETERMINER = (r"(?:the|an?|its|their|same|exact|one|two|both|no|rounded|this|each|any|every|other|another|all|"
              r"many|few|some|whose|these|those|of)")
HOUSE_WORDS = [
    (rf"\b{DETERMINER} places?\b", "position"),
    (r"\banew\b|\bafresh\b", "again, or restart"),
    (r"\btak(?:e|es|en|ing) \w+(?: \w+)? across\b|\btak(?:e|es|en|ing) across\b", "map or transfer"),
    (r"\bspokes?\b", "outgoing halfedge"),
    (r"\bin doubt\b|\ba doubt\b", "undecided, or the filter failed"),
    (r"\bbut for rounding\b", "up to rounding"),
    (r"\bno number\b", "NaN"),
    (r"\bis welcome\b|\bare welcome\b", "is allowed"),
    (r"\b(?:is|are|was|be) told\b|\btells?\b", "is notified of, returns, determines"),
    (r"\b(?:as|the same as) above(?=[.,;:)]|$)|\b(?:is|are|holds?) the same for\b", "write the sentence, or \\copydoc"),
    (r"\blike ones\b", "name the things"),
    (r"\bas wanted\b|\bif wanted\b", "optionally, or any number of times"),
    (r"\bwhat they are\b|\bas they are\b", "unchanged"),
    (r"\bon the way\b|\bon its way\b|\bin the way\b", "name the time or the position"),
    (r"\bis gone\b|\bare gone\b", "is removed, or no longer exists"),
    (r"\bcome to rest\b|\bhas come to\b", "ends with"),
]
RULES = [(re.compile(pattern, re.IGNORECASE), advice) for pattern, advice in STAND_INS + HOUSE_WORDS]


class Block:
    """Lines that make up a paragraph, an item of a list, a cell of a table, or a heading."""

    def __init__(self):
        self.words = []  # pairs of a word and its line

    def add(self, text, line):
        self.words += [(word, line) for word in text.split()]


SENTENCE_END = re.compile(r"[.!?][)\"'*]*$|[.!?]</?\w+>$")
ABBREVIATIONS = re.compile(r"(?:\b(?:e\.g|i\.e|cf|Fig|Figs|Eq|Eqs|Sec|Ch|No|vs|etc|al|resp))\.$|^\(?[A-Z]\.(?:-[A-Z]\.)?$")


def sentences(words):
    """Sentences of a block, as lists of pairs of a word and its line."""
    sentence = []
    for i, (word, line) in enumerate(words):
        sentence.append((word, line))
        following = words[i + 1][0] if i + 1 < len(words) else ""
        starts = not following or not following[0].islower()
        if SENTENCE_END.search(word) and not ABBREVIATIONS.search(word) and starts:
            yield sentence
            sentence = []
    if sentence:
        yield sentence


def count(sentence):
    """Words of a sentence: dashes, operators and other marks are none."""
    return sum(1 for word, _ in sentence if re.search(r"\w", word))


INLINE = [
    (re.compile(r"\\f\$.*?\\f\$", re.S), "Formula"),
    (re.compile(r"``.+?``|`[^`]+`", re.S), "Name"),
    (re.compile(r"\\cgalCite\{[^}]*\}"), ""),
    (re.compile(r"\\cgalFigureRef\{[^}]*\}"), "figure"),
    (re.compile(r"[\\@](?:ref|subpage|link)\s+\S+?(?=[\s,;:)]|\.(?:\s|$))(?:\s+\"([^\"]*)\")?"),
     lambda m: (m.group(1) or "Name") + "\n" * m.group(0).count("\n")),
    (re.compile(r"[\\@]copydoc\s+\S+"), "Name"),
    (re.compile(r"[\\@](?:anchor|image\s+html|c|p|a|e|b)\s+\S+"), "Name"),
    (re.compile(r"!\[([^\]]*)\]\([^)]*\)|\[([^\]]*)\]\([^)]*\)", re.S),
     lambda m: m.group(1) or m.group(2) or "Name"),
    (re.compile(r"https?://\S+?(?=[),;]?(?:\s|$))"), "Address"),
    (re.compile(r"&\w+;"), "x"),
    (re.compile(r"</?(?:b|i|em|sup|sub|a|code|br|p)\b[^>]*>"), ""),
    (re.compile(r"<[^<>\n]*>"), " "),
    (re.compile(r"\*\*|(?<!\w)\*(?=\w)|(?<=[\w.])\*(?!\w)"), ""),
]


def with_lines(pattern, replacement, text):
    """Substitutes, and keeps the number of lines."""
    def substitute(match):
        new = replacement(match) if callable(replacement) else replacement
        return new + "\n" * max(0, match.group(0).count("\n") - new.count("\n"))
    return pattern.sub(substitute, text)


COMMAND_BLOCK = re.compile(
    r"^\s*[\\@](?:defgroup|ingroup|namespace|page|mainpage|section|subsection|subsubsection|addtogroup|"
    r"tableofcontents|cgalExample|include|snippet|concept|cgalConcept|cgalHasModel|cgalModels|cgalRefines|"
    r"cgalPkg\w+|cgalClassifiedRefPages|cgalCRPSection|cgalFigureBegin|cgalFigureEnd|file|headerfile|"
    r"cgalNamedParams\w+|cgalParamNBegin|cgalParamNEnd|cgalParamType|cgalParamDefault|example|anchor|name|"
    r"sa|see|relates|memberof|internal)\b.*$")
ITEM = re.compile(r"^\s*(?:-#?|\*|\+|\d+\.)\s+")
FIELD = re.compile(r"^\s*[\\@](?:t?param(?:\[\w+\])?\s+\S+|returns?|result|throws?\s+\S+|exception\s+\S+|pre|post|"
                   r"note|warning|brief|details|invariant|remark|cgalParamDescription\{|retval\s+\S+|"
                   r"deprecated|todo)\s*")


def blocks_of(lines, is_markdown):
    """Blocks of numbered lines of prose."""
    block, previous_blank, in_code, in_list = Block(), True, False, False
    result = []

    def finish():
        nonlocal block
        if block.words:
            result.append(block)
        block = Block()

    for number, line in lines:
        stripped = line.strip()
        if is_markdown and stripped.startswith("```"):
            in_code = not in_code
            finish()
            continue
        if in_code:
            continue
        if not stripped:
            finish()
            previous_blank = True
            continue
        indent = len(line) - len(line.lstrip())
        if indent >= 4 and previous_blank and not in_list:
            continue  # a block of code continues until a line that is not indented
        is_item = ITEM.match(line)
        if indent == 0:
            in_list = bool(is_item)
        in_list = in_list or bool(is_item)
        previous_blank = False
        if COMMAND_BLOCK.match(line) or (is_markdown and stripped.startswith("#")):
            finish()
            continue
        if stripped.startswith("|"):
            finish()
            for cell in stripped.strip("|").split("|"):
                if not re.fullmatch(r"\s*:?-+:?\s*", cell):
                    block.add(cell, number)
                    finish()
            continue
        if is_item:
            finish()
            line = ITEM.sub("", line)
        if FIELD.match(line):
            finish()
            line = FIELD.sub("", line)
        block.add(line, number)
    finish()
    return result


def prepared(text):
    """The text without code and bibliography, formulas and names as one word each."""
    for begin, end in [("code", "endcode"), ("verbatim", "endverbatim"), ("htmlonly", "endhtmlonly")]:
        pattern = re.compile(rf"^[ \t]*[\\@]{begin}\b.*?[\\@]{end}\b", re.S | re.M)
        text = with_lines(pattern, "\n\n", text)
    text = with_lines(re.compile(r"\\f\[.*?\\f\]\s?", re.S), "\n\n", text)
    text = with_lines(re.compile(r"^- \\anchor cite_.*?(?=^- \\anchor|^\\|^\*/|\Z)", re.S | re.M), "\n", text)
    text = with_lines(re.compile(r"^\\image html \S+ (\"[^\"]*\").*$", re.M),
                      lambda m: m.group(1).strip('"'), text)
    for pattern, replacement in INLINE:
        text = with_lines(pattern, replacement, text)
    return text


def blocks_of_text(path):
    text = path.read_text().replace("/*!", "").replace("*/", "")
    lines = list(enumerate(prepared(text).split("\n"), 1))
    return blocks_of(lines, path.suffix == ".md")


def blocks_of_header(path):
    """Blocks of comments on lines of their own, and of those after members that Doxygen reads, except
    headers' copyright."""
    result, lines = [], []

    def finish():
        if lines:
            first = lines[0][0]
            text = prepared("\n".join(line for _, line in lines))
            numbered = [(first + i, line) for i, line in enumerate(text.split("\n"))]
            result.extend(blocks_of(numbered, False))
            lines.clear()

    in_block, was_public = False, False
    for number, line in enumerate(path.read_text().split("\n"), 1):
        stripped = line.strip()
        if in_block or stripped.startswith(("/*!", "/**")):
            in_block = "*/" not in stripped
            lines.append((number, re.sub(r"^/\*[!*]|\*/$|^\*(?!/)", "", stripped)))
        elif re.match(r"///?(?!/)", stripped):
            is_public = stripped.startswith("///")
            if lines and is_public != was_public:
                finish()
            was_public = is_public
            if not re.match(r"// (?:Copyright|SPDX)", stripped):
                lines.append((number, re.sub(r"^///?<? ?", "", stripped)))
        else:
            finish()
            trailing = re.search(r"///< ?(.*)$", line)
            if trailing:
                lines.append((number, trailing.group(1)))
                finish()
    finish()
    return result


LITERAL = re.compile(r"\"((?:[^\"\\\n]|\\.)*)\"")
RAW_LITERAL = re.compile(r"R\"(\w*)\((.*?)\)\1\"", re.S)
HELP_ROW = re.compile(r"^ {2,4}\S.*? {2,}")


# Headings, types and examples.
NO_SENTENCES = re.compile(r"-+$|[A-Z]\w+$|[\w, *]+ : |(?:pair of )?\(.*\w$|>>> |\.\.\. ")


def blocks_of_docstrings(text):
    """Blocks of docstrings. What an example prints ends with an empty line."""
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)):
            continue
        lines, is_example = [], False
        for number, line in enumerate(prepared(ast.get_docstring(node) or "").split("\n"), node.body[0].lineno):
            is_example = line.startswith(">>>") or is_example and line != ""
            is_text = not is_example and not NO_SENTENCES.match(line.strip())
            lines.append((number, line.strip() if is_text else ""))
        yield from blocks_of(lines, True)


def blocks_of_help(text):
    """Blocks of raw string literals, the help of commands: paragraphs, and rows of lists without examples."""
    for literal in RAW_LITERAL.finditer(text):
        first = text.count("\n", 0, literal.start()) + 1
        lines = [HELP_ROW.sub("- ", line) for line in literal[2].split("\n") if not line.startswith("  intrinsic ")]
        yield from blocks_of(enumerate(lines, first), False)


def blocks_of_source(path):
    """Blocks of messages: string literals with at least five words, adjacent ones joined."""
    text = with_lines(RAW_LITERAL, '""', path.read_text())
    text = "\n".join("" if re.match(r"\s*(?://|#)", line) else line for line in text.split("\n"))
    result, block, last = [], Block(), None
    for match in LITERAL.finditer(text):
        if last is None or text[last:match.start()].strip(" \n\t+") != "":
            if len(block.words) >= 5:
                result.append(block)
            block = Block()
        content = match.group(1).replace("\\n", " ").replace('\\"', '"')
        block.add(content, text.count("\n", 0, match.start()) + 1)
        last = match.end()
    if len(block.words) >= 5:
        result.append(block)
    return result


NO_SENTENCE = re.compile(r"// (?:----|clang-format|NOLINT|Copyright|SPDX)|//(?!\s|$)")
SENTENCE_START = re.compile(r"[A-Z0-9`(|~-]")


def comments(path):
    """Pairs of the first line of each comment on lines of its own, and its text. Section marks, licenses and
    indented formulas are none, nor are lines that continue a comment behind code."""
    text, first, before, behind_code = [], 0, "", None
    for number, line in enumerate([*path.read_text().split("\n"), ""], 1):
        stripped = line.strip()
        is_comment = stripped.startswith("//") and not stripped.startswith("///")
        column = line.find("//") if is_comment else None
        if is_comment and before[:column].strip() and before[column:column + 2] == "//":
            behind_code = column
        elif column != behind_code:
            behind_code = None
        if is_comment and behind_code is None and stripped != "//" and not NO_SENTENCE.match(stripped):
            first = first if text else number
            text.append(stripped[2:])
        elif text:
            if any(not part.startswith("   ") for part in text):
                yield first, " ".join(part.strip() for part in text)
            text = []
        before = line


def unmarked_comments(path):
    """Pairs of a line and what is wrong at the ends of a comment, without its commands of Doxygen."""
    for line, text in comments(path):
        text = re.split(r"\s*\\(?:pre|post|throws|returns)\b", text)[0]
        if not text:
            continue
        if not SENTENCE_START.match(text):
            yield line, f"a comment that starts with a small letter: {text[:40]} ..."
        if not re.search(r"[.:?!)]$", text):
            yield line, f"a comment that does not end with a mark: ... {text[-40:]}"


TEXT_IN_GROUP = re.compile(r"[\\\\@]ingroup\s+\w+\s+\S")


def texts_as_groups(path):
    """Pairs of a line and what is wrong: Doxygen takes words after a group for further groups."""
    for number, line in enumerate(path.read_text().split("\n"), 1):
        if TEXT_IN_GROUP.search(line):
            yield number, "text behind \\ingroup belongs on the next line"


def violations(path):
    """Pairs of a line and what is wrong in it."""
    if path.suffix in [".txt", ".md"]:
        blocks = blocks_of_text(path)
    elif path.suffix == ".py":
        blocks = blocks_of_docstrings(path.read_text())
    elif "demo" in path.relative_to(ROOT).parts[:1]:
        blocks = [*blocks_of_help(path.read_text()), *blocks_of_source(path)]
    else:
        blocks = blocks_of_header(path) + blocks_of_source(path)
    if path.suffix in [".h", ".cpp"]:
        yield from unmarked_comments(path)
        yield from texts_as_groups(path)
    for block in blocks:
        for sentence in sentences(block.words):
            words = count(sentence)
            if words > MOST_WORDS:
                start = " ".join(word for word, _ in sentence[:6])
                yield sentence[0][1], f"a sentence of {words} words: {start} ..."
        text, starts = "", []
        for word, line in block.words:
            starts.append((len(text), line))
            text += word + " "
        for pattern, advice in RULES:
            for match in pattern.finditer(text.rstrip()):
                line = max(line for start, line in starts if start <= match.start())
                yield line, f'"{match.group(0).strip()}": {advice}'


def files(patterns):
    for pattern in patterns:
        for path in sorted(ROOT.glob(pattern)):
            if not {"license", "CMakeLists.txt"} & set(path.parts):
                yield path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=Path)
    arguments = parser.parse_args()

    chosen = [path.resolve() for path in arguments.files] or list(files(TEXTS + HEADERS + SOURCES))
    total = 0
    for path in chosen:
        found = sorted(violations(path))
        total += len(found)
        for line, message in found:
            print(f"{path.relative_to(ROOT)}:{line}: {message}")
    if total:
        print(f"check_prose: {total} violations in {len(chosen)} files", file=sys.stderr)
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
