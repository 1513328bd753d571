"""Hostile input: files and scripts that a careless reader would crash on,
hang on or believe. CASES says for each what iritx must do with it.

A refused input: exit status 1, a message with file:line:col, nothing written.
An accepted one: exit status 0; the note says why it is legal."""
import gzip
import os
import struct
import zlib

POINTS = ' '.join('[%d 0 0]' % i for i in range(6))


def curve(head, knots=None, points=POINTS):
    kv = '  [KV %s]\n' % knots if knots else ''
    return '[OBJECT C\n [CURVE %s\n%s  %s\n ]\n]\n' % (head, kv, points)


def itd_texts():
    """{name: text}: data that is wrong, too large for what is there, or odd."""
    clamped = '0 0 0 0 1 1 1 1'
    return {
        'huge_count': curve('BSPLINE 1000000000 4 E3', clamped, '[0 0 0]'),
        'neg_count': curve('BSPLINE -5 4 E3', clamped, '[0 0 0]'),
        'overflow_count': curve('BSPLINE 99999999999999999999 4 E3', '0 0 1 1', '[0 0 0]'),
        'fraction_count': curve('BSPLINE 3.5 3 E3', '0 0 0 1 1 1'),
        'srf_product': '[OBJECT S\n [SURFACE BSPLINE 65536 65536 4 4 E3\n  [KV %s]\n  [KV %s]\n'
                       '  [0 0 0]\n ]\n]\n' % (clamped, clamped),
        'mv_dims': '[OBJECT M\n [MULTIVAR BSPLINE 60\n  %s\n  %s\n  E1\n  [KV 0 0 1 1]\n ]\n]\n'
                   % ('2 ' * 60, '2 ' * 60),
        'order_gt_n': curve('BSPLINE 3 1000000 E3', '0 0 0 1 1 1', '[0 0 0] [1 0 0] [2 0 0]'),
        'order_zero': curve('BSPLINE 3 0 E3', '0 1 2', '[0 0 0] [1 0 0] [2 0 0]'),
        'short_kv': curve('BSPLINE 6 4 E3', '0 0 0 0 1 1'),
        'nonmono_kv': curve('BSPLINE 5 4 E3', '0 0 0 0 -3 1 1 1 1'),
        'over_mult': curve('BSPLINE 6 4 E3', '0 0 0 0 0 0 1 1 1 1'),
        'zero_span': curve('BSPLINE 4 4 E3', '1 1 1 1 1 1 1 1'),
        'nan': curve('BEZIER 4 E3', None, '[nan 0 0] [inf 0 0] [1e999 0 0] [3 0 0]'),
        'hex_number': curve('BEZIER 2 E3', None, '[0x10 0 0] [1 0 0]'),
        'comma_number': curve('BEZIER 2 E2', None, '[1,5 0] [1 0]'),
        'zero_weights': curve('BEZIER 3 P3', None, '[0 0 0 0] [0 1 0 0] [0 2 0 0]'),
        'sign_weights': curve('BEZIER 3 P2', None, '[1 0 0] [-1 1 0] [1 2 0]'),
        'few_coords': curve('BEZIER 2 E3', None, '[0 0] [1 0 0]'),
        'eof': '[OBJECT C\n [CURVE BSPLINE 4 4 E3\n  [KV 0 0 0 0 1 1',
        'unbalanced': ']]]]]]\n',
        'empty': '',
        'bad_type': curve('BSPLINE 4 4 Q17', clamped, ''),
        'nul_byte': '[OBJECT C\0D [NUMBER 3]]\n',
        'deep': '[OBJECT A ' * 200000,
        'deep_closed': '[OBJECT A ' * 5000 + '[NUMBER 1]' + ']' * 5000,
        'long_name': '[OBJECT ' + 'A' * 1000000 + ' [NUMBER 3]]\n',
        'long_attr': '[OBJECT [ATTR ' + 'x' * 1000000 + '] A [NUMBER 3]]\n',
        'long_number': '[OBJECT A [NUMBER ' + '9' * 1000000 + ']]\n',
        'open_string': '[OBJECT A [STRING "never closed\n]]\n',
        'many_objects': '[OBJECT A [NUMBER 1]]\n' * 300000,
    }


def irt_texts():
    """{name: text}: scripts that loop, recurse, grow or reach out."""
    return {
        'rec': 'f = function(x): return = x;\nf = function(x): return = f(x+1);\na = f(1);\n',
        'rec_mutual': 'f = function(x): return = x;\ng = function(x): return = f(x);\n'
                      'f = function(x): return = g(x);\na = f(1);\n',
        'inf_for': 'for (i = 1, 0, 10, x = i);\n',
        'inf_while': 'while (1, x = 1);\n',
        'self_inc': 'include("self_inc.irt");\n',
        'paren': 'a = ' + '(' * 100000 + '1' + ')' * 100000 + ';\n',
        'unop': 'a = ' + '-' * 200000 + '1;\n',
        'power_chain': 'a = ' + '2^' * 100000 + '1;\n',
        'nested_if': 'if (1, ' * 20000 + 'a = 1' + ')' * 20000 + ';\n',
        'long_string': 'a = "' + 'x' * 1000000 + '";\n',
        'open_string': 'a = "never closed;\nb = 3;\n',
        'long_id': 'a' * 100000 + ' = 3;\n',
        'grow': 'a = list(1);\nfor (i = 1, 1, 60, a = list(a, a));\na;\n',
        'list_loop': 'a = list(1);\nsnoc(a, a);\na;\n',
        'fmt': 'printf("%s%n%99999999d", list(1));\n',
        'divzero': 'a = 1/0;\n',
        'nth': 'd = nth(list(1), 99);\n',
        'escape': 'save("../../../../pwned", 3);\n',
        'passwd': 'include("/etc/passwd");\n',
        'pipe': 'a = load("|id");\n',
        'system': 'system("touch pwned");\n',
        'huge_deg': 'c = cbezier(list(ctlpt(E1,0), ctlpt(E1,1)));\n'
                    'for (i = 1, 1, 40, c = symbprod(c, c));\n',
        'huge_list': 'a = nil();\nfor (i = 1, 1, 1e9, snoc(i, a));\n',
        'nul_byte': 'a = 1;\0 b = 2;\n',
        'binary': ''.join(chr(i * 37 % 256) for i in range(5000)),
    }


ROOT = '<iritx xmlns="urn:iritx:geometry" version="1">'


def xml_file(body):
    return ROOT + body + '</iritx>'


def xml_curve(head, points='0 0 1 0 2 0', attributes='type="E2"'):
    return xml_file('<object><curve %s>%s<points>%s</points></curve></object>'
                    % (attributes, head, points))


def laughs(use):
    """Ten entities, each ten times the one before."""
    text = '<?xml version="1.0"?>\n<!DOCTYPE lolz [\n<!ENTITY lol0 "lol">\n'
    for i in range(1, 10):
        text += '<!ENTITY lol%d "%s">\n' % (i, '&lol%d;' % (i - 1) * 10)
    return text + ']>\n' + use


def xml_foreign():
    """{name: text}: XML that reaches out, swells or nests."""
    entity = '<!DOCTYPE a [<!ENTITY x %s>]>'
    return {
        'lol': laughs(ROOT + '&lol9;</iritx>'),
        'lolattr': laughs('<iritx a="&lol9;"/>'),
        'quad': entity % ('"%s"' % ('x' * 50000)) + '<a>%s</a>' % ('&x;' * 20000),
        'xxe': entity % 'SYSTEM "file:///etc/hostname"' + '<a>&x;</a>',
        'parameter': '<!DOCTYPE a [<!ENTITY % x SYSTEM "file:///etc/hostname"> %x;]><a/>',
        'doctype': '<!DOCTYPE iritx SYSTEM "http://localhost:1/x.dtd">' + xml_file(''),
        'late_doctype': xml_file('<object/>') + '<!DOCTYPE a>',
        'entity': xml_file('<object><string>&x;</string></object>'),
        'xinclude': '<a xmlns:xi="http://www.w3.org/2001/XInclude">'
                    '<xi:include href="file:///etc/passwd" parse="text"/></a>',
        'xinclude_inside': xml_file(
            '<object xmlns:xi="http://www.w3.org/2001/XInclude">'
            '<xi:include href="file:///etc/passwd" parse="text"/></object>'),
        'deep257': '<a>' * 257 + '</a>' * 257,
        'deep3000': '<a>' * 3000 + '</a>' * 3000,
        'deep1000000': '<a>' * 1000000 + '</a>' * 1000000,
        'deep_ours': ROOT + '<object>' * 256 + '</object>' * 256 + '</iritx>',
        'deep_ours1000000': ROOT + '<object>' * 1000000,
        'attr11mb': '<a p="' + '1 ' * 5500000 + '"/>',
        'attr_ours': xml_file('<object name="' + 'x' * 11000000 + '"/>'),
        'attributes': ROOT[:-1] + ''.join(' a%d=""' % i for i in range(200000)) + '/>',
        'attributes_small': ROOT[:-1] + ''.join(' a%d=""' % i for i in range(6000)) + '/>',
        'comment11mb': xml_file('<!--' + 'x' * 11000000 + '-->'),
        'text11mb': xml_file('<object><string>' + 'x' * 11000000 + '</string></object>'),
        'many_nodes': '<a>' + '<b/>' * 2000000 + '</a>',
        'html': '<!DOCTYPE html><html><body>no</body></html>',
        'not_xml': 'just words',
        'json': '{"a": 1}',
        'cut': xml_file('<object/>')[:-3],
        'crossed': ROOT + '<object><list></object></list></iritx>',
        'twice': xml_file('<object/>') * 2,
        'nul': xml_file('<object><string>a\0b</string></object>'),
        'control': xml_file('<object><string>a\1b</string></object>'),
        'declared_utf16': '<?xml version="1.0" encoding="UTF-16"?>' + xml_file('<object/>'),
        'declared_ebcdic': '<?xml version="1.0" encoding="EBCDIC-US"?>' + xml_file('<object/>'),
        'unknown_encoding': '<?xml version="1.0" encoding="no-such"?>' + xml_file('<object/>'),
    }


def xml_ours():
    """{name: text}: our vocabulary, with contents that cannot be."""
    bezier = '<direction basis="bezier" order="3"/>'
    spline = '<direction basis="bspline" order="%s" length="%s"><knots>%s</knots></direction>'
    return {
        'empty_root': xml_file(''),
        'no_namespace': '<iritx version="1"><object/></iritx>',
        'version2': ROOT.replace('1">', '2">') + '<object/></iritx>',
        'unknown': xml_file('<object><sphere/></object>'),
        'unknown_attr': xml_file('<object colour="4"/>'),
        'mixed': xml_file('<object><number>1</number><point>1 2 3</point></object>'),
        'stray_text': xml_file('<object>1 2 3</object>'),
        'few': xml_curve(bezier, '0 0 1 0'),
        'many': xml_curve(bezier, '0 0 1 0 2 0 3 0'),
        'odd': xml_curve(bezier, '0 0 1 0 2'),
        'nan': xml_curve(bezier, 'nan 0 inf 0 1e999 0'),
        'hex_number': xml_curve(bezier, '0x10 0 1 0 2 0'),
        'comma': xml_curve(bezier, '1,5 0 1 0 2 0'),
        'zero_weights': xml_curve(bezier, '0 1 0 0 0 1 0 1 1', 'type="P2"'),
        'type19': xml_curve(bezier, '0 0 1 0 2 0', 'type="E19"'),
        'huge_length': xml_curve(spline % (4, 1000000000, '0 0 0 0 1 1 1 1')),
        'huge_product': xml_file(
            '<object><multivariate type="E1">' + '<direction basis="bezier" order="1024"/>' * 16
            + '<points>1</points></multivariate></object>'),
        'directions': xml_file('<object><multivariate type="E1">'
                               + '<direction basis="bezier" order="1"/>' * 17
                               + '<points>1</points></multivariate></object>'),
        'negative': xml_curve(spline % (2, -5, '0 0 1 1')),
        'order0': xml_curve(spline % (0, 3, '0 0 1 1')),
        'few_knots': xml_curve(spline % (3, 3, '0 0 0 1 1')),
        'falling_knots': xml_curve(spline % (3, 3, '0 0 1 0 1 1')),
        'no_span': xml_curve(spline % (3, 3, '1 1 1 1 1 1')),
        'edge': xml_file('<object><model><face><surface type="E1">' + bezier * 2
                         + '<points>1 2 3 4 5 6 7 8 9</points></surface><edges>1</edges></face>'
                           '</model></object>'),
        'triangle': xml_file('<object><triangularsurface type="E3" basis="bezier" length="32767">'
                             '<points>0 0 0</points></triangularsurface></object>'),
    }


def xml_texts():
    return {**xml_foreign(), **xml_ours()}


def gzip_bytes(data):
    return gzip.compress(data, 9, mtime=0)


def bomb(megabytes, unit=b' '):
    """A gzip file of so many MB of a unit: one compressed block, repeated."""
    block, crc = unit * ((1 << 20) // len(unit)), 0
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed = packer.compress(block) + packer.flush(zlib.Z_FULL_FLUSH)
    for _ in range(megabytes):
        crc = zlib.crc32(block, crc)
    head = b'\x1f\x8b\x08\0\0\0\0\0\0\xff'
    tail = packer.flush() + struct.pack('<II', crc, (megabytes << 20) & 0xffffffff)
    return head + packed * megabytes + tail


def binary_files():
    """{file name: bytes}: bytes that are no text, and broken compression."""
    good = gzip_bytes(b'[OBJECT C [NUMBER 3]]\n' * 1000)
    return {
        'bad_utf8.itd': b'[OBJECT \xff\xfe\xc0\x80 [NUMBER 3]]\n',
        'random.itd': bytes(i * i * 7 % 251 for i in range(100000)),
        'bomb.itd.gz': bomb(1500),
        'bomb_named.itd': bomb(300),
        'trunc.itd.gz': good[:-9],
        'crc.itd.gz': good[:-6] + b'\0\0' + good[-4:],
        'tail.itd.gz': good + b'garbage behind the end',
        'header.itd.gz': good[:5],
        'not_gzip.itd.gz': b'\x1f\x8b' + b'x' * 1000,
        'bomb.xml.gz': bomb(1024, b'<b/>'),
        'innocent.xml': bomb(1024, b'<b/>'),
        'latin1.xml': xml_file('<object name="caf\xe9"/>').encode('latin-1'),
        'utf16.xml': xml_file('<object/>').encode('utf-16'),
        'ebcdic.xml': ('<?xml version="1.0"?>' + xml_file('<object/>')).encode('cp037'),
        'overlong.xml': ROOT.encode() + b'<object name="\xc0\xbc"/></iritx>',
    }


# Inputs that are odd but legal: why they are accepted.
ACCEPTED = {
    'sign_weights.itd': 'weights of both signs are a curve with poles: loaded, with a warning',
    'many_objects.itd': '300000 small objects are only many',
    'long_name.itd': 'names and strings of files have no length limit but memory',
    'long_attr.itd': 'as long_name',
    'open_string.itd': 'a string of a file ends with its line',
    'list_loop.irt': 'a list put into itself is put there as a copy',
    'nul_byte.irt': 'a control character ends its line, as in IRIT',
    'power_chain.irt': 'a chain of operators is no nesting',
}


def write_all(folder):
    """Writes every input; returns their names, sorted."""
    for suffix, texts in (('.itd', itd_texts()), ('.irt', irt_texts()), ('.xml', xml_texts())):
        for name, text in texts.items():
            with open(os.path.join(folder, name + suffix), 'w', encoding='latin-1') as file:
                file.write(text)
    for name, data in binary_files().items():
        with open(os.path.join(folder, name), 'wb') as file:
            file.write(data)
    return sorted(os.listdir(folder))
