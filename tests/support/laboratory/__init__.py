"""The merge laboratory: packages as people write them, changed specs and models, updates, a judge.

specs     random specs, and all the ways they change
edits     what developers do to a package, each line with a mark
judge     what became of it; knows nothing of the merge
mutants   merges that are wrong, each of which the judge must see
layouts   where older packages have their files
trials    one update after the other, and the counts
"""
