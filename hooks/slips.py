"""What the usual slips in XML are and how to mend them: expat says "invalid token" of them all."""

from __future__ import annotations

import re
from xml.parsers import expat

from .faults import quoted, shown

_ENTITY = r"&(?!(?:amp|lt|gt|quot|apos|#\d+|#x[0-9a-fA-F]+);)"
_TYPOGRAPHIC = "\u201c\u201d\u201e\u201f\u2018\u2019\u201a\u00ab\u00bb"
_VALUE = r"\"[^\"]*\"|'[^']*'"


_OTHERS = {
    expat.errors.XML_ERROR_DUPLICATE_ATTRIBUTE: "{word} is given twice",
    expat.errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT: "nothing may follow </package>",
    expat.errors.XML_ERROR_MISPLACED_XML_PI: "nothing may stand before <?xml",
    expat.errors.XML_ERROR_UNCLOSED_CDATA_SECTION: "<![CDATA[ is not closed; end it with ]]>",
}


def slip(fault: str, text: str, at: int) -> str | None:
    """Return what is wrong at a place where expat finds a fault; None for a rare one."""
    before, after = text[:at], text[at:]
    if fault in _OTHERS:
        return _OTHERS[fault].format(word=_word(after))
    if not text.strip():
        return "the file is empty; a spec begins with <package"
    if "<" not in before and not after.startswith("<"):
        start = quoted(text.strip().splitlines()[0])
        return f"a spec is XML and begins with <package, not with {start}"
    if before.rfind("<!--") > before.rfind("-->"):
        return "a comment has no -- inside; write - there" if before.endswith("--") else None
    if after.startswith("<!--"):
        return "the comment is not closed; end it with -->"
    if fault == expat.errors.XML_ERROR_UNCLOSED_TOKEN:
        before, after = text, ""
    return _in_text(text, before, after) or _in_tag(before, after)


def _in_text(text: str, before: str, after: str) -> str | None:
    """Return the slip of a sign that means something in XML."""
    if re.search(r"&[^\s;&<>\"']*$", before):
        return "write & as &amp;"
    if found := re.match(rf"[^&]*{_ENTITY}(\w+);", after):
        return f"&{found[1]}; is no word of XML; write the character itself"
    if after.startswith("/") and _is_closed(before[:-1]):
        return _OTHERS[expat.errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT]
    if re.search(r"<!-?$", before):
        return "a comment begins with <!-- and ends with -->"
    if found := re.search(r"</([\w:.-]+)\s*/?$", before):
        name = shown(found[1])
        return f"</{name}> has nothing but its name" if after else f"</{name}> lacks its >"
    if before.endswith(("<", "</")):
        return "after < comes the name of a tag, with no blank between; write < itself as &lt;"
    if after[:1] and not after[0].isprintable() and after[0] not in " \t\r\n":
        return f"U+{ord(after[0]):04X} is no blank and no text; drop it"
    return None


def _is_closed(text: str) -> bool:
    """Say whether a text is well-formed XML by itself."""
    try:
        expat.ParserCreate().Parse(text, True)
    except expat.ExpatError:
        return False
    return True


def _in_tag(before: str, after: str) -> str | None:
    """Return the slip in a tag that is open where expat gives up."""
    tag = before[max(before.rfind("<"), 0) :]
    rest = re.sub(_VALUE, '""', tag)
    sign = after[:1]
    if found := re.search(r"=\s*(?:\"(?!\")|'(?!')|\"\"[^\"\s]*\"$)", rest):
        return _in_value(before, tag, rest[: found.start()], after)
    if found := re.search(r"([\w:.-]+)\s*=\s*$", rest):
        if sign and sign in _TYPOGRAPHIC:
            return f'{quoted(sign)} is no quote of XML; write "'
        return f'after {found[1]}= comes the value in quotes: {found[1]}="{_word(after)}"'
    if rest.endswith('""'):
        if sign in (",", ";"):
            return f"blanks separate attributes; drop {quoted(sign)}"
        if sign == "<":
            return _no_end(before, tag)
        inside = "a quote in a value is &quot; or &apos;"
        return f"after the value of an attribute comes a blank, > or />; {inside}"
    if rest[-1:].isspace() and re.match(r"[\d.-]", after):
        return f"the name of an attribute begins with a letter, not with {quoted(sign)}"
    if rest.endswith("/"):
        return "/ and > of /> stand together"
    if sign == "<":
        return _no_end(before, tag)
    if found := re.search(r"\s([\w.-]+):?\s*$", rest):
        return f'an attribute has a value: {found[1]}="..."'
    return None if sign else _no_end(before, tag)


def _in_value(before: str, tag: str, start: str, after: str) -> str:
    """Return why a value does not end where it should."""
    value = tag[len(start) :]
    if "\n" in value or ">" in value or not after:
        line = before.count("\n", 0, len(before) - len(value)) + 1
        name = start.split()[-1] if start.split() else ""
        return (
            f"the value of {shown(name)} in line {line} is not closed; its quotes must be the same"
        )
    return "write < as &lt; in a value"


def _word(text: str) -> str:
    found = re.match(r"[^\s<>/?\"'=]+", text)
    return shown(found[0]) if found else "..."


def _no_end(before: str, tag: str) -> str | None:
    line = before.count("\n", 0, len(before) - len(tag)) + 1
    name = re.match(r"<[\w:.-]+", tag)
    return f"{shown(name[0])}> of line {line} lacks its > or />" if name else None
