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


def gzip_bytes(data):
    return gzip.compress(data, 9, mtime=0)


def bomb(megabytes):
    """A gzip file of so many MB of blanks: one compressed block, repeated."""
    block, crc = b' ' * (1 << 20), 0
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
    for suffix, texts in (('.itd', itd_texts()), ('.irt', irt_texts())):
        for name, text in texts.items():
            with open(os.path.join(folder, name + suffix), 'w', encoding='latin-1') as file:
                file.write(text)
    for name, data in binary_files().items():
        with open(os.path.join(folder, name), 'wb') as file:
            file.write(data)
    return sorted(os.listdir(folder))
