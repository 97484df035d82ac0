# Makes docs/results.md from the page of `multipath paper`, in which every element has lines of its own.
# usage: sed -f docs/builders/results.sed index.html
1,/^<body>/d
/^<svg/,/^<\/svg>/d
/^<img/d
/^<div/d
/^<\/div/d
/^<\/figure/d
/^<\/body/d
/^<\/html/d
s|<code>|`|g
s|</code>|`|g
s|<em>|*|g
s|</em>|*|g
/^<nav /d
/^<a /d
/^<h1 /{ s|<h1[^>]*>\(.*\)</h1>|# \1|; G; }
/^<h2 /{ s|<h2[^>]*>\(.*\)</h2>|## \1|; G; }
/^<p>/{ s|<p>\(.*\)</p>|\1|; G; }
s|^</table></div>$||
/^<tr><th>/{
    s/^<tr><th>/| /
    s/<\/th><th>/ | /g
    s/<\/th><\/tr>/ |/
    p
    s/[^|]\{1,\}/ --- /g
}
s/^<tr><td>/| /
s/<\/td><td>/ | /g
s/<\/td><\/tr>/ |/
/^<figure /{ s|.*id="\([^"]*\)".*|![\1](results/\1)|; G; }
/^<figcaption>/{
    s|<figcaption>\(.*\)<details><summary>command</summary>`\(.*\)`</details></figcaption>|\1@@```console@\2@```@|
    y|@|\n|
}
