"""The expectations that a script test carries as comments, and the output of
the interpreter as items to hold against them (docs/development.md 4).

An item is one line that PRINTF wrote, or one value that an expression
statement showed, however many lines its dump has; a value reads as its text
without the outer brackets: 3, "abc", POINT 1 2 3, CURVE BEZIER 2 E2 [0 0]
[1 1], LIST (1, "a", LIST ())."""
import math
import re

COMMENT = re.compile(r'#\s*(expect\b|args:|files:)\s*(.*)$')
HEADER = re.compile(r'^(\s*)(\S+)\s+\(\s*\d+\)\s*-\s*(.*?)\s+type\s*$')
NUMBER = re.compile(r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![A-Za-z_0-9])'
                    r'|[-+]?(?:nan|inf)(?![A-Za-z_0-9])')
DIAGNOSTIC = re.compile(r':(\d+):(?:(\d+):)? (error|warning|note): (.*)')


class BadTest(Exception):
    """The test itself is wrong."""


class Expectations:
    """What one script expects. items: (line, tolerance or None, text);
    messages: (line, kind, text)."""

    def __init__(self):
        self.args, self.files, self.items, self.messages = [], [], [], []
        self.status, self.rest, self.written = None, False, []

    def add(self, number, word, text):
        if word == 'args:':
            self.args += text.split()
        elif word == 'files:':
            self.files += text.split()
        else:
            self.add_expect(number, text)

    def add_expect(self, number, text):
        patterns = (
            (r':\s?(.*)', lambda m: self.items.append((number, None, m[1]))),
            (r'near (\S+?):\s*(.*)',
             lambda m: self.items.append((number, float(m[1]), m[2]))),
            (r'(error|warning)(?: (\d+))?(?::\s*(.*))?',
             lambda m: self.messages.append((int(m[2] or number), m[1], m[3] or ''))),
            (r'exit (\d+)', lambda m: setattr(self, 'status', int(m[1]))),
            (r'file: (\S+)', lambda m: self.written.append(m[1])),
            (r'anything', lambda m: setattr(self, 'rest', True)))
        for pattern, action in patterns:
            match = re.fullmatch(pattern, text.rstrip())
            if match:
                action(match)
                return
        raise BadTest('line %d: not an expectation: "expect %s"' % (number, text))

    def expected_status(self):
        if self.status is not None:
            return self.status
        return 1 if any(kind == 'error' for _, kind, _ in self.messages) else 0


def read_expectations(text):
    found = Expectations()
    for number, line in enumerate(text.splitlines(), 1):
        match = COMMENT.search(line)
        if match:
            found.add(number, match[1], match[2])
    if not (found.items or found.messages or found.written or found.rest
            or found.status is not None):
        raise BadTest('expects nothing')
    return found


def squeeze(text):
    return ' '.join(text.split())


def depth_change(text):
    bare = re.sub(r'"(?:\\.|[^"\\])*"', '', text)
    return bare.count('[') - bare.count(']')


def strip_object(text):
    """[OBJECT [attributes] NAME value ] -> value without its brackets."""
    text = squeeze(text)
    body = re.sub(r'^\[OBJECT (?:\[(?:"(?:\\.|[^"\\])*"|[^\]"])*\] ?)*\S+ ?', '', text)
    body = body[:-1].strip() if body.endswith(']') else body
    match = re.fullmatch(r'\[(?:NUMBER |STRING )?(.*)\]', body)
    return match[1].strip() if match else body


def read_dump(lines, i):
    """The bracketed text that starts at lines[i]; and the index after it."""
    text, depth = '', 0
    while i < len(lines):
        text += ' ' + lines[i]
        depth += depth_change(lines[i])
        i += 1
        if depth <= 0:
            break
    return strip_object(text), i


def read_value(lines, i):
    """The value whose header is lines[i]; and the index after it."""
    head = HEADER.match(lines[i])
    indent = len(head[1])
    i += 1
    if head[3] != 'Object List':
        if i < len(lines) and lines[i].strip().startswith('['):
            return read_dump(lines, i)
        return '', i
    elements = []
    while i < len(lines):
        inner = HEADER.match(lines[i])
        if not inner or len(inner[1]) <= indent:
            break
        value, i = read_value(lines, i)
        elements.append(value)
    return 'LIST (%s)' % ', '.join(elements), i


def read_items(output):
    lines = [line for line in output.splitlines() if line.strip()]
    items, i = [], 0
    while i < len(lines):
        if HEADER.match(lines[i]):
            item, i = read_value(lines, i)
        else:
            item, i = squeeze(lines[i]), i + 1
        items.append(item)
    return items


def near(expected, actual, tolerance):
    """Equal texts, but for numbers x, y with |x - y| <= tol max(1, |x|, |y|)."""
    if squeeze(NUMBER.sub(' # ', expected)) != squeeze(NUMBER.sub(' # ', actual)):
        return False
    for a, b in zip(NUMBER.findall(expected), NUMBER.findall(actual)):
        x, y = float(a), float(b)
        if math.isinf(x) or math.isinf(y):
            equal = x == y
        elif math.isnan(x) or math.isnan(y):
            equal = math.isnan(x) and math.isnan(y)
        else:
            equal = abs(x - y) <= tolerance * max(1, abs(x), abs(y))
        if not equal:
            return False
    return True


def matches(expected, tolerance, actual):
    if tolerance is None:
        return squeeze(expected) == actual
    return near(expected, actual, tolerance)


def item_problems(want, items):
    for number, tolerance, text in want.items:
        if not items:
            yield 'line %d: expected "%s", but there is no more output' % (number, text)
            return
        actual = items.pop(0)
        if not matches(text, tolerance, actual):
            yield 'line %d: expected "%s", got "%s"' % (number, text, actual)
    if items and not want.rest:
        yield 'not expected: "%s"' % '", "'.join(items[:5])


def message_problems(want, errors, script):
    """Each expected message is there, and no error or warning that is not."""
    found = []
    for line in errors.splitlines():
        match = DIAGNOSTIC.search(line)
        if match and line[:match.start()].endswith(script):
            found.append((int(match[1]), match[3], match[4]))
    unmet = list(found)
    for number, kind, text in want.messages:
        hit = next((f for f in unmet if f[0] == number and f[1] == kind and text in f[2]), None)
        if hit:
            unmet.remove(hit)
        else:
            yield 'line %d: expected %s "%s"' % (number, kind, text)
    for number, kind, text in unmet:
        if kind in ('error', 'warning'):
            yield 'line %d: %s not expected: %s' % (number, kind, text)


def problems(want, status, output, errors, script):
    """All that is wrong, as lines; none if the test passed."""
    found = list(item_problems(want, read_items(output)))
    found += message_problems(want, errors, script)
    if status != want.expected_status():
        found.append('exit status %d, expected %d' % (status, want.expected_status()))
    return found
