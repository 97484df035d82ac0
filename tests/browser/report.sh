# The paper's report in a real browser, without a network: every figure must be drawn, not only be there.
# usage: report.sh PROGRAM ROOT [SCREENSHOT]     in an empty folder; CHROMIUM names the browser (chromium)
. "$2/tests/cli/check.sh"
screenshot=${3:-report.png}
chromium=${CHROMIUM:-chromium}

# The page in a frame, looked at by a script from outside; the result is written where --dump-dom finds it.
cat >look.html <<'HTML'
<!DOCTYPE html><meta charset="utf-8"><pre id="result">the page did not load</pre>
<iframe id="page" src="paper/index.html" style="width:1100px;height:800px"></iframe>
<script>
const line = text => { document.getElementById('result').textContent += text + '\n'; };
const as_image = source => new Promise((done, fail) => {
  const image = new Image(); image.onload = () => done(image); image.onerror = () => fail('cannot be decoded'); image.src = source; });
// Share of the pixels that differ clearly from the most frequent colour.
function drawn(image) {
  const canvas = document.createElement('canvas'); canvas.width = 300; canvas.height = 225;
  const context = canvas.getContext('2d', { willReadFrequently: true }); context.drawImage(image, 0, 0, 300, 225);
  const data = context.getImageData(0, 0, 300, 225).data, counts = new Map();
  for (let i = 0; i < data.length; i += 4) { const k = (data[i] >> 4) * 256 + (data[i + 1] >> 4) * 16 + (data[i + 2] >> 4); counts.set(k, (counts.get(k) || 0) + 1); }
  return 1 - Math.max(...counts.values()) / (300 * 225); }
async function look() {
  const page = document.getElementById('page').contentDocument;
  document.getElementById('result').textContent = '';
  for (const figure of page.querySelectorAll('figure')) {
    const svg = figure.querySelector('svg'), box = (svg || figure.querySelector('img')).getBoundingClientRect();
    const source = svg ? 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(new XMLSerializer().serializeToString(svg)) : figure.querySelector('img').src;
    let share = 0;
    try { share = drawn(await as_image(source)); } catch (error) { line('error ' + figure.id + ' ' + error); }
    line(`figure ${figure.id} ${Math.round(box.width)} ${Math.round(box.height)} ${share.toFixed(4)}`);
  }
  const view = document.getElementById('page').contentWindow;
  line('resources ' + view.performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:')).length);
  line('wide ' + (page.documentElement.scrollWidth > page.documentElement.clientWidth ? 1 : 0));
  line('rows ' + page.querySelectorAll('tr').length);
  line('end');
}
document.getElementById('page').addEventListener('load', look);
</script>
HTML

# usage: browse OPTIONS... URL
browse() {
    timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --hide-scrollbars --allow-file-access-from-files \
        --host-resolver-rules="MAP * ~NOTFOUND" --enable-logging=stderr "$@" 2>browser.log
}

report() { "$program" paper --quick -o paper 2>err; }
check "paper --quick makes a report" report

looked() { browse --virtual-time-budget=30000 --dump-dom "file://$PWD/look.html" >dom.html && sed -n 's/.*<pre id="result">//; /^figure\|^resources\|^wide\|^rows\|^error\|^end/p' dom.html >seen && grep -q '^end$' seen || { head -c 2000 dom.html; return 1; }; }
check "the browser opens it" looked

every_figure() {
    expected=$(ls paper/*.svg paper/*.png | wc -l)
    [ "$(grep -c '^figure' seen)" -eq "$expected" ] || { echo "expected $expected figures"; cat seen; return 1; }
    # name, width, height on the page, share of the pixels that are not background
    awk '/^error/ { bad = 1; print } /^figure/ && !($3 >= 200 && $4 >= 120 && $5 > 0.004) { bad = 1; print } END { exit bad }' seen
}
check "every figure that was made is on the page, with a size and something drawn in it" every_figure

alone() { grep -qx 'resources 0' seen && ! grep -Eq '(src|href)="(https?:)?//' paper/index.html; }
check "the page loads nothing else" alone

fits() { grep -qx 'wide 0' seen; }
check "the page is not wider than the window" fits

no_errors() { ! grep -E 'CONSOLE.*(rror|Refused)' browser.log; }
check "the console shows no error" no_errors

pictured() { browse --window-size=1100,3000 --screenshot="$screenshot" "file://$PWD/paper/index.html" && [ "$(wc -c <"$screenshot")" -gt 50000 ]; }
check "a screenshot is kept" pictured

narrow() {
    sed 's/width:1100px/width:380px/' look.html >narrow.html && browse --virtual-time-budget=30000 --dump-dom "file://$PWD/narrow.html" >dom.html &&
        grep -qx 'wide 0' dom.html || { grep wide dom.html; return 1; }
}
check "on a telephone it is not wider than the screen either" narrow
finish
