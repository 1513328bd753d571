#!/usr/bin/env python3
"""compare.py EXPECTED ACTUAL [--rtol R] [--atol A] [--errors] [--all-attrs]

Compares two outputs of an interpreter token by token.
 * Numbers compare as numbers: |a - b| <= atol + rtol max(|a|, |b|); nan is
   equal to nan, inf to inf of the same sign.
 * Every other token compares literally but without case; blanks and line
   breaks do not count.
 * The reference count in the header  NAME (n) - Typename type  is ignored.
 * A line that belongs to no dump (header or [OBJECT ...]) and does not start
   with "=" is a diagnostic: a run of them is one token <error>, which counts
   only with --errors.
 * Attributes that only IRIT's own bookkeeping writes are dropped and the order
   of an object's simple attributes is ignored, unless --all-attrs.
Prints the first difference. Exit status: 0 equal, 1 different, 2 usage."""
import argparse
import math
import re
import sys

HEADER = re.compile(r'^\s*(\S+)\s+\(\s*\d+\)\s*-\s*(.*?)\s+type\s*$', re.I)
BOOKKEEPING = re.compile(
    r'\[(?:GeomType|RngError|SingleSol|BspDomainMin|BspDomainMax)\s+[^\[\]]*\]', re.I)
ATTRIBUTES = re.compile(
    r'(?<=\[OBJECT)((?:\s*\[[A-Za-z_]\w*(?:\s+(?:"[^"]*"|[^\[\]"]*))?\])+)', re.I)
TOKEN = re.compile(r'''
    (?P<err><error>)
  | (?P<num>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?
     | [-+]?(?:nan|inf(?:inity)?)(?![A-Za-z0-9_]))
  | (?P<word>[A-Za-z_][A-Za-z0-9_]*)
  | (?P<sym>\S)''', re.X | re.I)


def depth_change(line):
    """The balance of brackets in a line of a dump, strings left out."""
    depth, quoted, escaped = 0, False, False
    for char in line:
        if escaped:
            escaped = False
        elif char == '\\':
            escaped = True
        elif char == '"':
            quoted = not quoted
        elif not quoted:
            depth += (char == '[') - (char == ']')
    return depth


def sort_attributes(line):
    line = BOOKKEEPING.sub(' ', line)
    return ATTRIBUTES.sub(lambda m: ' ' + ' '.join(
        sorted(re.findall(r'\[[^\[\]]*\]', m.group(1)), key=str.lower)), line)


def output_lines(text, errors):
    """(number, line) of what counts: dumps, "=" lines, <error> for the rest."""
    depth, in_error = 0, False
    for number, line in enumerate(text.splitlines(), 1):
        line = line.strip()
        head = HEADER.match(line)
        if not line:
            continue
        if depth > 0 or line.upper().startswith('[OBJECT'):
            depth = max(depth + depth_change(line), 0)
        elif head:
            line = '%s - %s type' % head.groups()
        elif not line.startswith('='):
            if errors and not in_error:
                yield number, '<error>'
            in_error = True
            continue
        in_error = False
        yield number, line


def tokens(text, errors, all_attrs):
    """[(value, line number)], the value a float or a string."""
    found = []
    for number, line in output_lines(text, errors):
        for m in TOKEN.finditer(line if all_attrs else sort_attributes(line)):
            word = m.group(0)
            found.append((float(word) if m.lastgroup == 'num' else word.lower(), number))
    return found


def same(a, b, rtol, atol):
    if isinstance(a, str) or isinstance(b, str):
        return a == b
    if math.isnan(a) or math.isnan(b):
        return math.isnan(a) and math.isnan(b)
    if math.isinf(a) or math.isinf(b):
        return a == b
    return abs(a - b) <= atol + rtol * max(abs(a), abs(b))


def show(token):
    if token is None:
        return 'the end'
    value = token[0]
    return '%s (line %d)' % (repr(value) if isinstance(value, str) else '%.17g' % value, token[1])


def parse_options(words):
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('--rtol', type=float, default=1e-9)
    parser.add_argument('--atol', type=float, default=1e-11)
    parser.add_argument('--errors', action='store_true')
    parser.add_argument('--all-attrs', action='store_true')
    parser.add_argument('files', nargs='*')
    return parser.parse_args(words)


def difference(expected, actual, options):
    """The first difference in words, or None."""
    want = tokens(expected, options.errors, options.all_attrs)
    got = tokens(actual, options.errors, options.all_attrs)
    for i in range(max(len(want), len(got))):
        a = want[i] if i < len(want) else None
        b = got[i] if i < len(got) else None
        if a is None or b is None or not same(a[0], b[0], options.rtol, options.atol):
            return 'token %d: expected %s, got %s' % (i + 1, show(a), show(b))
    return None


def main(words):
    options = parse_options(words)
    if len(options.files) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    texts = []
    for name in options.files:
        with open(name, encoding='latin-1') as file:
            texts.append(file.read())
    found = difference(texts[0], texts[1], options)
    if found:
        print(found)
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
